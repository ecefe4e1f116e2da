#ifndef BOUNDARY_RECOVERY_3_PROGRAM_OUTPUT_BUFFER_H
#define BOUNDARY_RECOVERY_3_PROGRAM_OUTPUT_BUFFER_H

#include <charconv>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

// Writes numbers and text to a file, many times faster than a stream of the standard library does: a mesh of millions
// of cells must not take longer to be written than to be made. Numbers are read back as they are, bit for bit.
class Output_buffer
{
  static constexpr std::size_t capacity = std::size_t(1) << 20;
  static constexpr std::size_t longest_number = 32;

  std::ofstream m_os;
  std::vector<char> m_buffer;
  std::size_t m_size = 0;

public:
  explicit Output_buffer(const std::string& file)
    : m_os(file, std::ios::binary), m_buffer(capacity + longest_number)
  { }

  Output_buffer& operator<<(const char c)
  {
    m_buffer[m_size++] = c;
    flush_if_full();
    return *this;
  }

  Output_buffer& operator<<(const std::string& text)
  {
    write(text.data(), text.size());
    return *this;
  }

  Output_buffer& operator<<(const char* text) { return *this << std::string(text); }

  Output_buffer& operator<<(const int n) { return put_number(n); }
  Output_buffer& operator<<(const long n) { return put_number(n); }
  Output_buffer& operator<<(const long long n) { return put_number(n); }
  Output_buffer& operator<<(const unsigned int n) { return put_number(n); }
  Output_buffer& operator<<(const unsigned long n) { return put_number(n); }
  Output_buffer& operator<<(const unsigned long long n) { return put_number(n); }

  // the shortest text that is this number and no other one
  Output_buffer& operator<<(const double x)
  {
#ifdef __cpp_lib_to_chars
    return put_number(x);
#else // older libraries know integers only
    m_size += static_cast<std::size_t>(std::snprintf(&m_buffer[m_size], longest_number, "%.17g", x));
    flush_if_full();
    return *this;
#endif
  }

  // the bytes of a number, in the order of this machine
  template <typename T>
  void put_bytes(const T& x) { write(reinterpret_cast<const char*>(&x), sizeof(T)); }

  // returns `false` if anything could not be written
  bool close()
  {
    flush();
    m_os.close();
    return ! m_os.fail();
  }

private:
  template <typename T>
  Output_buffer& put_number(const T x)
  {
    char* const begin = &m_buffer[m_size];
    m_size += static_cast<std::size_t>(std::to_chars(begin, begin + longest_number, x).ptr - begin);
    flush_if_full();
    return *this;
  }

  void write(const char* const bytes, const std::size_t n)
  {
    if(n > capacity - m_size)
      flush();
    if(n > capacity)
      m_os.write(bytes, static_cast<std::streamsize>(n));
    else
    {
      std::memcpy(&m_buffer[m_size], bytes, n);
      m_size += n;
    }
  }

  void flush_if_full()
  {
    if(m_size >= capacity)
      flush();
  }

  void flush()
  {
    m_os.write(m_buffer.data(), static_cast<std::streamsize>(m_size));
    m_size = 0;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_OUTPUT_BUFFER_H
