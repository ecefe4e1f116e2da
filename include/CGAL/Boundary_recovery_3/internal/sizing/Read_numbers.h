// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_READ_NUMBERS_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_READ_NUMBERS_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <cstddef>
#include <istream>
#include <locale>
#include <string>

namespace CGAL {
namespace Boundary_recovery_3 {
namespace internal {

/*
 * Reads words and numbers from a text with comments, which begin with `#` and end with the line, and knows in which
 * line it is. Numbers are written as in C++, with a point, whatever the locale of the stream is.
 */
class Read_numbers
{
public:
  explicit Read_numbers(std::istream& in) : m_in(in), m_locale(in.imbue(std::locale::classic())) { }

  ~Read_numbers() { m_in.imbue(m_locale); }

  Read_numbers(const Read_numbers&) = delete;
  Read_numbers& operator=(const Read_numbers&) = delete;

  // Reads a number, or a word; returns whether there is one.
  template <typename Number_or_word>
  bool operator()(Number_or_word& x)
  {
    skip();
    return static_cast<bool>(m_in >> x);
  }

  // Reads a position that the file counts from `first`; `end` is behind the last one, counted from 0.
  bool read_position(std::size_t& position, const std::size_t first, const std::size_t end)
  {
    long long number;
    if(! (*this)(number) || number < static_cast<long long>(first))
      return false;
    position = static_cast<std::size_t>(number) - first;
    return position < end;
  }

  // Whether nothing but blanks and comments is left.
  bool is_at_end()
  {
    skip();
    return m_in.peek() == std::char_traits<char>::eof();
  }

  // Leaves out what is not a word that begins with a letter.
  void skip_numbers()
  {
    std::string word;
    for(skip(); ! is_letter(m_in.peek()) && (m_in >> word); skip())
      { }
  }

  // What is missing, or wrong, and where.
  std::string message(const std::string& text) const { return "line " + std::to_string(m_line) + ": " + text; }

private:
  static bool is_letter(const int c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

  // Leaves out blanks and comments.
  void skip()
  {
    for(int c = m_in.peek(); c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '#'; c = m_in.peek())
    {
      m_in.get();
      if(c == '#')
        while(m_in.peek() != '\n' && m_in.get() != std::char_traits<char>::eof())
          { }
      m_line += c == '\n';
    }
  }

  std::istream& m_in;
  std::locale m_locale;
  std::size_t m_line = 1;
};

} // namespace internal
} // namespace Boundary_recovery_3
} // namespace CGAL

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_SIZING_READ_NUMBERS_H
