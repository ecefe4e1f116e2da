#ifndef BOUNDARY_RECOVERY_3_PROGRAM_BYTE_STRING_H
#define BOUNDARY_RECOVERY_3_PROGRAM_BYTE_STRING_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

typedef std::vector<char> Bytes;

// As the hash FNV-1a of 64 bits, but eight bytes at a time, with the upper bits mixed in. Any single byte that changes
// changes it, since each step is a bijection.
class Byte_hash
{
  std::uint64_t m_value = 14695981039346656037u;

public:
  Byte_hash& add(const void* const bytes, std::size_t n)
  {
    const char* next = static_cast<const char*>(bytes);
    for(; n >= sizeof(std::uint64_t); n -= sizeof(std::uint64_t), next += sizeof(std::uint64_t))
    {
      std::uint64_t word;
      std::memcpy(&word, next, sizeof(word));
      step(word);
    }
    for(; n > 0; --n, ++next)
      step(static_cast<unsigned char>(*next));
    return *this;
  }

  template <typename T>
  Byte_hash& add(const T& x)
  {
    static_assert(std::is_arithmetic<T>::value, "padding would be hashed");
    return add(&x, sizeof(T));
  }

  // the length as well, so that two texts are not taken for one
  Byte_hash& add(const std::string& text)
  {
    add(text.size());
    return add(text.data(), text.size());
  }

  std::uint64_t value() const { return m_value; }

private:
  void step(const std::uint64_t word)
  {
    m_value = (m_value ^ word) * 1099511628211u;
    m_value ^= m_value >> 32;
  }
};

// Puts numbers, and arrays of them, one after the other, in the byte order of this machine.
class Byte_writer
{
  Bytes& m_bytes;

public:
  explicit Byte_writer(Bytes& bytes) : m_bytes(bytes) { }

  template <typename T>
  void put(const T& x)
  {
    static_assert(std::is_trivially_copyable<T>::value, "it is more than its bytes");
    const char* const begin = reinterpret_cast<const char*>(&x);
    m_bytes.insert(m_bytes.end(), begin, begin + sizeof(T));
  }

  template <typename T>
  void put(const std::vector<T>& v)
  {
    static_assert(std::is_trivially_copyable<T>::value, "it is more than its bytes");
    put(std::uint64_t(v.size()));
    const char* const begin = reinterpret_cast<const char*>(v.data());
    m_bytes.insert(m_bytes.end(), begin, begin + v.size() * sizeof(T));
  }
};

// Takes them again. Whatever the bytes are, it reads none that is not there.
class Byte_reader
{
  const Bytes& m_bytes;
  std::size_t m_next = 0;

public:
  explicit Byte_reader(const Bytes& bytes) : m_bytes(bytes) { }

  bool is_at_end() const { return m_next == m_bytes.size(); }

  template <typename T>
  T get()
  {
    T x;
    take(&x, sizeof(T));
    return x;
  }

  template <typename T>
  void get(std::vector<T>& v)
  {
    const std::uint64_t n = get<std::uint64_t>();
    if(n > (m_bytes.size() - m_next) / sizeof(T))
      throw std::runtime_error("an array is longer than what there is");
    v.resize(static_cast<std::size_t>(n));
    take(v.data(), v.size() * sizeof(T));
  }

private:
  void take(void* const to, const std::size_t n)
  {
    if(n > m_bytes.size() - m_next)
      throw std::runtime_error("the data end too early");
    if(n > 0)
      std::memcpy(to, m_bytes.data() + m_next, n);
    m_next += n;
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_BYTE_STRING_H
