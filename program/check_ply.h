#ifndef BOUNDARY_RECOVERY_3_PROGRAM_CHECK_PLY_H
#define BOUNDARY_RECOVERY_3_PROGRAM_CHECK_PLY_H

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

// Finds out whether a PLY file has all the items that it announces, and what CGAL's reader leaves out: numbers of
// faces. CGAL's reader makes room for a list before it reads it, so a damaged length would exhaust the memory.
class Ply_checker
{
  // a property of an element; `length_size` is 0 unless it is a list
  struct Property
  {
    std::size_t length_size, size;
    bool is_signed;
    std::string name;
    bool is_number_of_faces;  // which may be a patch
    std::vector<int> numbers; // those of all faces
  };

  struct Element
  {
    std::string name;
    unsigned long long number;
    std::vector<Property> properties;
  };

  const std::string& m_text;
  std::size_t m_position = 0;
  bool m_is_ascii = true, m_is_big_endian = false;
  std::vector<Element> m_elements;

public:
  explicit Ply_checker(const std::string& text) : m_text(text) { }

  bool operator()()
  {
    if(! read_header())
      return false;
    for(Element& element : m_elements)
      for(unsigned long long i = 0; i < element.number; ++i)
        for(Property& property : element.properties)
          if(! (property.is_number_of_faces ? read_number(property) : skip(property)))
            return false;
    return true;
  }

  // the patches of the faces, if a property has integers for them; of several, the first one
  std::vector<int> patches(std::vector<std::string>& notes) const
  {
    std::vector<int> result;
    std::string name;
    for(const Element& element : m_elements)
      for(const Property& property : element.properties)
        if(property.is_number_of_faces && name.empty())
        {
          name = property.name;
          result = property.numbers;
        }
        else if(property.is_number_of_faces)
          notes.push_back("a number of the faces that is left out, as " + name + " is their patch: " + property.name);
    return result;
  }

private:
  // the number of bytes of a type by its name; 0 if there is no such type
  static std::size_t size_of(const std::string& type)
  {
    static const char* const names[][2] = { { "char", "int8" }, { "uchar", "uint8" }, { "short", "int16" },
      { "ushort", "uint16" }, { "int", "int32" }, { "uint", "uint32" }, { "float", "float32" },
      { "double", "float64" } };
    static const std::size_t sizes[] = { 1, 1, 2, 2, 4, 4, 4, 8 };
    for(int i = 0; i < 8; ++i)
      if(type == names[i][0] || type == names[i][1])
        return sizes[i];
    return 0;
  }

  static bool is_integer(const std::string& type) { return type.find("float") != 0 && type != "double"; }

  static bool is_color(const std::string& name)
  {
    for(const char* color : { "red", "green", "blue", "alpha" })
      if(name == color)
        return true;
    return false;
  }

  bool read_header()
  {
    for(;;)
    {
      const std::size_t end = m_text.find('\n', m_position);
      if(end == std::string::npos)
        return false;
      std::istringstream line(m_text.substr(m_position, end - m_position));
      m_position = end + 1;
      std::string keyword, word;
      line >> keyword >> word;
      if(keyword == "end_header")
        return true;
      if(keyword == "format")
      {
        m_is_ascii = word == "ascii";
        m_is_big_endian = word == "binary_big_endian";
      }
      else if(keyword == "element")
      {
        m_elements.emplace_back();
        m_elements.back().name = word;
        if(! (line >> m_elements.back().number) || m_elements.back().number > m_text.size())
          return false;
      }
      else if(keyword == "property" && ! read_property(line, word))
        return false;
    }
  }

  bool read_property(std::istream& line, const std::string& type)
  {
    std::string length_type, item_type = type;
    if(m_elements.empty() || (type == "list" && ! (line >> length_type >> item_type)))
      return false;
    const bool is_list = type == "list";
    Property property = { is_list ? size_of(length_type) : 0, size_of(item_type), type[0] != 'u', "", false, { } };
    line >> property.name;
    property.is_number_of_faces = m_elements.back().name == "face" && ! is_list && is_integer(type) &&
                                  ! is_color(property.name);
    m_elements.back().properties.push_back(property);
    return property.size > 0 && (! is_list || property.length_size > 0);
  }

  // The sign is that of the highest bit.
  bool read_number(Property& property)
  {
    unsigned long long bits = 0;
    if(! read_length(property.size, bits))
      return false;
    const unsigned long long half = 1ull << (8 * property.size - 1);
    const bool is_negative = ! m_is_ascii && property.is_signed && bits >= half;
    property.numbers.push_back(static_cast<int>(is_negative ? bits - 2 * half : bits));
    return true;
  }

  bool skip(const Property& property)
  {
    unsigned long long length = 1;
    if(property.length_size > 0 && ! read_length(property.length_size, length))
      return false;
    const std::size_t rest = m_text.size() - m_position;
    if(length > rest || (! m_is_ascii && length * property.size > rest))
      return false;
    if(! m_is_ascii)
      m_position += static_cast<std::size_t>(length) * property.size;
    for(; m_is_ascii && length > 0; --length)
      if(next_word() == nullptr)
        return false;
    return true;
  }

  bool read_length(const std::size_t size, unsigned long long& length)
  {
    if(m_is_ascii)
    {
      const char* const word = next_word();
      length = word == nullptr ? 0 : std::strtoull(word, nullptr, 10); // a negative one becomes large
      return word != nullptr;
    }
    if(size > m_text.size() - m_position)
      return false;
    length = 0;
    for(std::size_t i = 0; i < size; ++i)
      length = 256 * length + static_cast<unsigned char>(m_text[m_position + (m_is_big_endian ? i : size - 1 - i)]);
    m_position += size;
    return true;
  }

  // the next word of the text, or null at its end
  const char* next_word()
  {
    static constexpr const char* blanks = " \t\r\n\v\f";
    const std::size_t begin = m_text.find_first_not_of(blanks, m_position);
    m_position = (std::min)(m_text.size(), m_text.find_first_of(blanks, begin));
    return begin == std::string::npos ? nullptr : m_text.c_str() + begin;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_CHECK_PLY_H
