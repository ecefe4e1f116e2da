#ifndef BOUNDARY_RECOVERY_3_PROGRAM_UTF8_H
#define BOUNDARY_RECOVERY_3_PROGRAM_UTF8_H

#include <cstddef>
#include <string>

// Names in files, and of files, may be in any encoding; what is written is UTF-8.

// the number of bytes of the character in UTF-8 that begins at a position, 0 if none does
inline std::size_t length_of_utf8_character(const std::string& text, const std::size_t position)
{
  const auto byte = [&](const std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(position);
  const std::size_t length = first < 0x80 ? 1 : first < 0xc2 || first > 0xf4 ? 0
                           : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  if(position + length > text.size())
    return 0;
  for(std::size_t i = 1; i < length; ++i)
    if(byte(position + i) < 0x80 || byte(position + i) > 0xbf)
      return 0;
  const unsigned char second = length > 1 ? byte(position + 1) : 0;
  const bool is_none = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                       (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
  return is_none ? 0 : length;
}

inline bool is_utf8(const std::string& text)
{
  std::size_t length = 1;
  for(std::size_t i = 0; i < text.size() && length > 0; i += length)
    length = length_of_utf8_character(text, i);
  return length > 0;
}

// the text if it is UTF-8; else each of its bytes is taken for a character of Latin-1
inline std::string as_utf8(const std::string& text)
{
  if(is_utf8(text))
    return text;
  std::string result;
  for(const char c : text)
  {
    const unsigned char byte = static_cast<unsigned char>(c);
    if(byte < 0x80)
      result += c;
    else
      (result += static_cast<char>(0xc0 | (byte >> 6))) += static_cast<char>(0x80 | (byte & 0x3f));
  }
  return result;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_UTF8_H
