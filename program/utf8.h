#ifndef BOUNDARY_RECOVERY_3_PROGRAM_UTF8_H
#define BOUNDARY_RECOVERY_3_PROGRAM_UTF8_H

#include <boost/locale/utf.hpp>

#include <iterator>
#include <string>

// Names in files, and of files, may be in any encoding; what is written is UTF-8.

inline bool is_utf8(const std::string& text)
{
  namespace utf = boost::locale::utf;
  for(auto p = text.begin(); p != text.end();)
    if(! utf::is_valid_codepoint(utf::utf_traits<char>::decode(p, text.end())))
      return false;
  return true;
}

// the text if it is UTF-8; else each of its bytes is taken for a character of Latin-1
inline std::string as_utf8(const std::string& text)
{
  if(is_utf8(text))
    return text;
  std::string result;
  for(const char c : text)
    boost::locale::utf::utf_traits<char>::encode(static_cast<unsigned char>(c), std::back_inserter(result));
  return result;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_UTF8_H
