#ifndef BOUNDARY_RECOVERY_3_PROGRAM_TASK_STORE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_TASK_STORE_H

#include "byte_string.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

// What is known of the results of tasks on a disk that several processes see. A result has a file of its own. The key
// stands for all that the results depend on: what was stored with another one does not count, and stays.
//
// A file is written under another name, and gets its own when all of it is on the disk: who is killed, or finds the
// disk full, leaves nothing that looks like a result. What is read is checked nevertheless: files get damaged.
class Task_store
{
  static constexpr std::uint64_t magic = 0x31306b7361743362u; // with the version of the format
  static constexpr std::size_t size_of_header = 5 * sizeof(std::uint64_t);

  std::string m_folder; // empty: nothing is stored
  std::uint64_t m_key = 0;

public:
  Task_store() = default;

  // makes the folder if it does not exist
  Task_store(const std::string& folder, const std::uint64_t key) : m_folder(folder), m_key(key)
  {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if(! std::filesystem::is_directory(folder, error))
      throw std::runtime_error("cannot make the folder " + folder);
  }

  bool is_used() const { return ! m_folder.empty(); }

  std::string file_of(const std::size_t task) const
  {
    static const char digits[] = "0123456789abcdef";
    std::string key;
    for(int shift = 60; shift >= 0; shift -= 4)
      key += digits[(m_key >> shift) & 15];
    return (std::filesystem::path(m_folder) / (key + "_" + std::to_string(task) + ".part")).string();
  }

  // returns `false` if there is no such result, or not all of it as it was stored
  bool load(const std::size_t task, Bytes& result) const
  {
    Bytes file;
    if(! read(file_of(task), file) || file.size() < size_of_header)
      return false;
    Byte_reader reader(file);
    if(reader.get<std::uint64_t>() != magic || reader.get<std::uint64_t>() != m_key ||
       reader.get<std::uint64_t>() != task)
      return false;
    const std::uint64_t size = reader.get<std::uint64_t>(), checksum = reader.get<std::uint64_t>();
    if(size != file.size() - size_of_header ||
       checksum != checksum_of(task, file.data() + size_of_header, static_cast<std::size_t>(size)))
      return false;
    result.assign(file.begin() + size_of_header, file.end());
    return true;
  }

  // throws if not all of it can be written, and says why
  void save(const std::size_t task, const Bytes& result) const
  {
    Bytes header;
    Byte_writer writer(header);
    writer.put(magic);
    writer.put(m_key);
    writer.put(std::uint64_t(task));
    writer.put(std::uint64_t(result.size()));
    writer.put(checksum_of(task, result.data(), result.size()));
    const std::string file = file_of(task), unfinished = file + "." + std::to_string(::getpid()) + ".unfinished";
    try
    {
      write(unfinished, header, result);
      if(std::rename(unfinished.c_str(), file.c_str()) != 0)
        fail(file);
      keep_name();
    }
    catch(...)
    {
      ::unlink(unfinished.c_str());
      throw;
    }
  }

private:
  // of the header, too, as far as it is not compared with what is expected
  std::uint64_t checksum_of(const std::size_t task, const char* const bytes, const std::size_t n) const
  {
    return Byte_hash().add(m_key).add(std::uint64_t(task)).add(std::uint64_t(n)).add(bytes, n).value();
  }

  static bool read(const std::string& name, Bytes& bytes)
  {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(name, error);
    if(error)
      return false;
    std::ifstream is(name, std::ios::binary);
    bytes.resize(static_cast<std::size_t>(size));
    return static_cast<bool>(is.read(bytes.data(), static_cast<std::streamsize>(bytes.size())));
  }

  [[noreturn]] static void fail(const std::string& name)
  {
    throw std::runtime_error("cannot write " + name + ": " + std::strerror(errno));
  }

  static void write(const std::string& name, const Bytes& header, const Bytes& result)
  {
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if(descriptor < 0)
      fail(name);
    const bool is_written = write(descriptor, header) && write(descriptor, result) && ::fsync(descriptor) == 0;
    const int error = errno;
    const bool is_closed = ::close(descriptor) == 0; // some file systems tell only now that they are full
    if(! is_written)
      errno = error;
    if(! is_written || ! is_closed)
      fail(name);
  }

  static bool write(const int descriptor, const Bytes& bytes)
  {
    std::size_t done = 0;
    while(done < bytes.size())
    {
      const ssize_t n = ::write(descriptor, bytes.data() + done, bytes.size() - done);
      if(n < 0 && errno != EINTR)
        return false;
      if(n > 0)
        done += static_cast<std::size_t>(n);
    }
    return true;
  }

  // After a power failure, the new name must be in the folder as well. Where folders cannot be synchronized, the result
  // would be missing then, never wrong.
  void keep_name() const
  {
    const int descriptor = ::open(m_folder.c_str(), O_RDONLY | O_DIRECTORY);
    if(descriptor < 0)
      return;
    ::fsync(descriptor);
    ::close(descriptor);
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_TASK_STORE_H
