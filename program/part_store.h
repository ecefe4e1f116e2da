#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PART_STORE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PART_STORE_H

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
#include <vector>

// Parts of a mesh, and what else several processes have to know, on a disk that they all see. A file has several
// records, which can be read one by one. The key stands for all that the files depend on: what was stored with another
// one does not count, and stays.
//
// A file is written under another name, and gets its own when all of it is on the disk: who is killed, or finds the
// disk full, leaves nothing that looks like a file. What is read is checked nevertheless: files get damaged.
class Part_store
{
  static constexpr std::uint64_t magic = 0x32306b7361743363u; // with the version of the format
  static constexpr std::size_t size_of_word = sizeof(std::uint64_t);
  static constexpr std::size_t size_of_header = 5 * size_of_word;

  std::string m_folder;
  std::uint64_t m_key = 0;
  bool m_is_durable = false;

public:
  Part_store() = default;

  // Makes the folder if it does not exist. What is durable outlives a power failure; it takes the time of the disk.
  Part_store(const std::string& folder, const std::uint64_t key, const bool is_durable)
    : m_folder(folder), m_key(key), m_is_durable(is_durable)
  {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if(! std::filesystem::is_directory(folder, error))
      throw std::runtime_error("cannot make the folder " + folder);
  }

  std::string file_of(const std::string& name) const
  {
    static const char digits[] = "0123456789abcdef";
    std::string key;
    for(int shift = 60; shift >= 0; shift -= 4)
      key += digits[(m_key >> shift) & 15];
    return (std::filesystem::path(m_folder) / (key + "_" + name + ".part")).string();
  }

  // returns `false` if there is no such record, or not all of it as it was stored
  bool load(const std::string& name, const std::size_t record, Bytes& result) const
  {
    std::error_code error;
    const std::string file = file_of(name);
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    std::ifstream is(file, std::ios::binary);
    Bytes header(size_of_header);
    if(error || size < size_of_header || ! is.read(header.data(), std::streamsize(header.size())))
      return false;
    Byte_reader reader(header);
    if(reader.get<std::uint64_t>() != magic || reader.get<std::uint64_t>() != m_key)
      return false;
    const std::uint64_t number = reader.get<std::uint64_t>(), length = reader.get<std::uint64_t>();
    if(length != size || record >= number || number > (size - size_of_header) / (2 * size_of_word))
      return false;
    Bytes table(static_cast<std::size_t>(number) * 2 * size_of_word);
    return is.read(table.data(), std::streamsize(table.size())) &&
           reader.get<std::uint64_t>() == checksum_of_header(name, length, table) &&
           load(is, table, record, result);
  }

  void remove(const std::string& name) const
  {
    std::error_code ignored;
    std::filesystem::remove(file_of(name), ignored);
  }

  // throws if not all of it can be written, and says why
  void save(const std::string& name, const std::vector<Bytes>& records) const
  {
    const Bytes header = header_of(name, records);
    const std::string file = file_of(name), unfinished = file + "." + std::to_string(::getpid()) + ".unfinished";
    try
    {
      write(unfinished, header, records);
      if(std::rename(unfinished.c_str(), file.c_str()) != 0)
        fail(file);
      if(m_is_durable)
        keep_name();
    }
    catch(...)
    {
      ::unlink(unfinished.c_str());
      throw;
    }
  }

  // removes the folder with all that is in it, unless that is durable
  void remove_temporary_folder() const
  {
    std::error_code ignored;
    if(! m_is_durable && ! m_folder.empty())
      std::filesystem::remove_all(m_folder, ignored);
  }

private:
  // five words, and then two for each record: its size, and its checksum
  Bytes header_of(const std::string& name, const std::vector<Bytes>& records) const
  {
    Bytes table, header;
    Byte_writer table_writer(table), writer(header);
    std::uint64_t length = size_of_header;
    for(const Bytes& record : records)
    {
      table_writer.put(std::uint64_t(record.size()));
      table_writer.put(checksum_of(record));
      length += 2 * size_of_word + record.size();
    }
    writer.put(magic);
    writer.put(m_key);
    writer.put(std::uint64_t(records.size()));
    writer.put(length);
    writer.put(checksum_of_header(name, length, table));
    header.insert(header.end(), table.begin(), table.end());
    return header;
  }

  static std::uint64_t checksum_of(const Bytes& record)
  {
    return Byte_hash().add(std::uint64_t(record.size())).add(record.data(), record.size()).value();
  }

  // as far as the header is not compared with what is expected
  std::uint64_t checksum_of_header(const std::string& name, const std::uint64_t length, const Bytes& table) const
  {
    return Byte_hash().add(m_key).add(name).add(length).add(table.data(), table.size()).value();
  }

  // the stream is behind the table
  static bool load(std::istream& is, const Bytes& table, const std::size_t record, Bytes& result)
  {
    Byte_reader reader(table);
    std::uint64_t offset = 0, size = reader.get<std::uint64_t>(), checksum = reader.get<std::uint64_t>();
    for(std::size_t k = 0; k < record; ++k)
    {
      offset += size;
      size = reader.get<std::uint64_t>();
      checksum = reader.get<std::uint64_t>();
    }
    result.resize(static_cast<std::size_t>(size));
    return is.seekg(static_cast<std::streamoff>(offset), std::ios::cur) &&
           is.read(result.data(), static_cast<std::streamsize>(size)) && checksum == checksum_of(result);
  }

  [[noreturn]] static void fail(const std::string& name)
  {
    throw std::runtime_error("cannot write " + name + ": " + std::strerror(errno));
  }

  void write(const std::string& name, const Bytes& header, const std::vector<Bytes>& records) const
  {
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if(descriptor < 0)
      fail(name);
    bool is_written = write(descriptor, header);
    for(const Bytes& record : records)
      is_written = is_written && write(descriptor, record);
    is_written = is_written && (! m_is_durable || ::fsync(descriptor) == 0);
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

  // After a power failure, the new name must be in the folder as well. Where folders cannot be synchronized, the file
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

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PART_STORE_H
