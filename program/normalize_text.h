#ifndef BOUNDARY_RECOVERY_3_PROGRAM_NORMALIZE_TEXT_H
#define BOUNDARY_RECOVERY_3_PROGRAM_NORMALIZE_TEXT_H

#include "lower_case.h"
#include "word_reader.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

// Files say the same in several ways, of which CGAL's readers know some only. Here the content of a file is brought
// into one of these before it is read; what those readers understand as it is stays as it is. A note is made of
// everything in the file that will not be in the surface, or that may not be there.

namespace read_surface_internal {

inline bool is_blank(const char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

inline std::string first_word(const std::string& line)
{
  const auto begin = std::find_if_not(line.begin(), line.end(), is_blank);
  return std::string(begin, std::find_if(begin, line.end(), is_blank));
}

inline std::string last_word(const std::string& text)
{
  const auto end = std::find_if_not(text.rbegin(), text.rend(), is_blank);
  return std::string(std::find_if(end, text.rend(), is_blank).base(), end.base());
}

inline bool is_binary(const std::string& extension, const std::string& text)
{
  return text.find('\0') != std::string::npos ||
         (extension == ".ply" && text.find("format binary") != std::string::npos);
}

// calls `f` with each line, without its end
template <typename Function>
void for_each_line(const std::string& text, const Function& f)
{
  for(std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = (std::min)(text.find('\n', begin), text.size());
    f(text.substr(begin, end - begin));
    begin = end + 1;
  }
}

inline bool ends_with_backslash(const std::string& line)
{
  const std::size_t end = line.find_last_not_of('\r');
  return end != std::string::npos && line[end] == '\\';
}

// A statement with numbers goes on in the next line if a backslash ends it. Comments and names do not: they may be
// paths of Windows.
inline bool can_be_continued(const std::string& statement)
{
  const std::string word = first_word(statement);
  return word[0] == 'v' || word == "f" || word == "l" || word == "p";
}

// CGAL's reader of OBJ files stops at lines, before 6.0 knows no continued statements, then continues all of them, and
// knows blanks only between the vertices of a face: after a tab, it would go on with the next blank, and lose what is
// between.
inline std::string normalize_obj(const std::string& text, std::vector<std::string>& notes)
{
  std::string result, statement;
  std::size_t number_of_polylines = 0;
  result.reserve(text.size() + 1);
  const auto add = [&](const std::string& line)
  {
    statement += line;
    const bool has_backslash = ends_with_backslash(line);
    if(has_backslash)
      statement.replace(statement.rfind('\\'), std::string::npos, " ");
    if(has_backslash && can_be_continued(statement))
      return;
    std::replace_if(statement.begin(), statement.end(), is_blank, ' ');
    if(first_word(statement) == "l")
      ++number_of_polylines;
    else
      result += statement + '\n';
    statement.clear();
  };
  for_each_line(text, add);
  result += statement; // a backslash at the end of the file
  if(number_of_polylines > 0)
    notes.push_back("lines of the OBJ file that are left out: " + std::to_string(number_of_polylines));
  return result;
}

// CGAL's reader of STL files knows keywords in lower case only, and wants `endsolid` after each solid.
inline std::string normalize_text_stl(const std::string& text, std::vector<std::string>& notes)
{
  static const char* const keywords[] = { "facet", "outer", "vertex", "endloop", "endfacet" };
  std::string result;
  bool is_in_solid = false;
  result.reserve(text.size() + 1);
  for_each_line(text, [&](const std::string& line)
  {
    const std::string original = first_word(line), word = lower_case(original);
    const bool is_solid = word == "solid", is_end = word == "endsolid";
    if(is_solid && is_in_solid)
      result += "endsolid\n";
    if(is_solid || is_end) // what follows is a name
    {
      is_in_solid = is_solid;
      result += word + ' ' + line.substr(line.find(original) + original.size()); // CGAL looks for a blank
    }
    else
      result += std::find(std::begin(keywords), std::end(keywords), word) == std::end(keywords) ? line
                                                                                              : lower_case(line);
    result += '\n';
  });
  if(lower_case(last_word(text)) == "endfacet")
  {
    result += "endsolid\n";
    notes.push_back("the STL file has no endsolid: it may have been cut off");
  }
  return result;
}

// CGAL's reader takes as many triangles from a binary STL file as its header says. A program that did not know
// how many there would be when it began to write leaves too small a number there; a larger one is an error.
inline void correct_number_of_stl_triangles(std::string& text, std::vector<std::string>& notes)
{
  const std::size_t header = 84, triangle = 50;
  std::uint32_t counted = 0; // as it is in memory, like CGAL's reader
  if(text.size() < header)
    return;
  std::memcpy(&counted, text.data() + header - sizeof(counted), sizeof(counted));
  const std::size_t stored = (text.size() - header) / triangle, rest = (text.size() - header) % triangle;
  if(counted > stored)
    throw Unreadable("its header announces " + std::to_string(counted) + " triangles, and it has "
                     + std::to_string(stored));
  if(counted == stored && rest == 0)
    return;
  const std::size_t end = header + triangle * counted;
  const bool is_padded = text.find_first_not_of('\0', end) == std::string::npos;
  if(is_padded || rest != 0)
  {
    notes.push_back("bytes after the last triangle of the STL file that are left out: "
                    + std::to_string(text.size() - end));
    return;
  }
  notes.push_back("triangles that the STL file announces: " + std::to_string(counted)
                  + ", that it has, and that are read: " + std::to_string(stored));
  counted = static_cast<std::uint32_t>(stored);
  std::memcpy(&text[header - sizeof(counted)], &counted, sizeof(counted));
}

// brings the content of a file into a form that CGAL's readers understand
inline void normalize(const std::string& extension, std::string& text, std::vector<std::string>& notes)
{
  const bool is_text = ! is_binary(extension, text);
  if((is_text || extension != ".stl") && text.compare(0, 3, "\xef\xbb\xbf") == 0) // a byte order mark
    text.erase(0, 3);
  if(! is_text)
  {
    if(extension == ".stl")
      correct_number_of_stl_triangles(text, notes);
    return;
  }
  if(text.find('\n') == std::string::npos)
    std::replace(text.begin(), text.end(), '\r', '\n');
  if(extension == ".obj")
    text = normalize_obj(text, notes);
  else if(extension == ".stl")
    text = normalize_text_stl(text, notes);
}

} // namespace read_surface_internal

#endif // BOUNDARY_RECOVERY_3_PROGRAM_NORMALIZE_TEXT_H
