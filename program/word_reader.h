#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WORD_READER_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WORD_READER_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>

// What a reader says of a file that it cannot read, with the line.
struct Unreadable
  : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Reads a text word by word; `#` begins a comment, if there are any. Where something else stands than what is asked
// for, it throws `Unreadable`.
class Word_reader
{
  static constexpr const char* blanks = " \t\r\v\f\n";

  const std::string& m_text;
  const bool m_has_comments;
  std::size_t m_position = 0;

public:
  explicit Word_reader(const std::string& text, const bool has_comments = true)
    : m_text(text), m_has_comments(has_comments)
  { }

  // whether there is another word
  bool has_word() { return skip(blanks); }

  // whether there is another word in this line
  bool has_word_in_line() { return skip(" \t\r\v\f") && m_text[m_position] != '\n'; }

  std::string word()
  {
    if(! has_word())
      fail("it ends too early");
    const std::size_t begin = m_position;
    m_position = (std::min)(m_text.find_first_of(blanks, begin), m_text.size());
    return m_text.substr(begin, m_position - begin);
  }

  // the next word, which stays the next one
  std::string peek()
  {
    const std::size_t position = m_position;
    const std::string result = has_word() ? word() : std::string();
    m_position = position;
    return result;
  }

  // what is left of this line
  std::string line()
  {
    const std::size_t begin = m_position;
    const std::size_t end = (std::min)(m_text.find('\n', begin), m_text.size());
    m_position = end;
    return m_text.substr(begin, end - begin);
  }

  void expect(const std::string& expected)
  {
    const std::string found = word();
    if(found != expected)
      fail(expected + " is expected, not " + found);
  }

  double number()
  {
    const std::string text = word();
    char* end = nullptr;
    const double x = std::strtod(text.c_str(), &end);
    if(*end != '\0')
      fail("a number is expected, not " + text);
    return x;
  }

  long long integer()
  {
    const double x = number();
    if(! (std::abs(x) < 9007199254740992.) || x != std::floor(x)) // 2^53: all integers up to here are numbers
      fail("an integer is expected");
    return static_cast<long long>(x);
  }

  // how many of something follow, each with as many words at least
  std::size_t count(const std::size_t number_of_words = 1)
  {
    const long long n = integer();
    if(n < 0 || static_cast<std::size_t>(n) > m_text.size() / number_of_words)
      fail("there are not as many as it announces");
    return static_cast<std::size_t>(n);
  }

  void skip_words(const std::size_t n)
  {
    for(std::size_t i = 0; i < n; ++i)
      word();
  }

  template <typename Point>
  Point point()
  {
    const double x = number(), y = number();
    return Point(x, y, number());
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    const auto line = 1 + std::count(m_text.begin(), m_text.begin() + static_cast<std::ptrdiff_t>(m_position), '\n');
    throw Unreadable("line " + std::to_string(line) + ": " + what);
  }

private:
  // skips such characters, and comments; returns whether there is something else
  bool skip(const char* const characters)
  {
    m_position = (std::min)(m_text.find_first_not_of(characters, m_position), m_text.size());
    while(m_has_comments && m_position < m_text.size() && m_text[m_position] == '#')
    {
      m_position = (std::min)(m_text.find('\n', m_position), m_text.size());
      m_position = (std::min)(m_text.find_first_not_of(characters, m_position), m_text.size());
    }
    return m_position < m_text.size();
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WORD_READER_H
