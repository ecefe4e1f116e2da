#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WHOLE_FILE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WHOLE_FILE_H

#include "interruption.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ios>
#include <string>
#include <system_error>

#ifndef _WIN32
#include <fcntl.h>
#include <unistd.h>
#endif

// Whether a file can be opened for writing, and takes anything: a device that is full does not even take no bytes. If
// not, `errno` tells why.
inline bool opens_for_writing(const std::string& file)
{
#ifdef _WIN32
  return std::ofstream(file, std::ios::app).is_open();
#else
  const int descriptor = open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT, 0666);
  if(descriptor < 0)
    return false;
  const bool takes_anything = write(descriptor, "", 0) == 0;
  const int error = errno;
  close(descriptor);
  errno = error;
  return takes_anything;
#endif
}

// The same, and whether there is space on the disk; leaves no trace of the trial.
inline bool can_be_written(const std::string& file)
{
  std::error_code error;
  const bool existed = std::filesystem::exists(file, error);
  if(! opens_for_writing(file))
    return false;
  const auto space = std::filesystem::space(file, error);
  const bool is_full = ! error && space.capacity > 0 && space.available == 0;
  if(! existed)
    std::filesystem::remove(std::filesystem::canonical(file, error), error); // not a link to it
  if(is_full)
    errno = ENOSPC;
  return ! is_full;
}

// copies what is in a file; returns `false` if that fails
inline bool copy_bytes(const std::string& from, const std::string& to)
{
  std::ifstream is(from, std::ios::binary);
  std::ofstream os(to, std::ios::binary);
  os << is.rdbuf();
  os.close();
  return is.good() && os.good();
}

// A file that is there as a whole, or as it was before: it is written under another name, with the same extension,
// beside it, and gets its name at last. What is no ordinary file, as a device or a pipe, is written as it is, and so is
// a file that has several names, or is in a folder that takes no new ones. `errno` is 0 when it can be written.
class Whole_file
{
  std::filesystem::path m_file;
  std::string m_name;           // under which it is written
  bool m_has_other_name = false;

public:
  explicit Whole_file(const std::string& file) : m_file(file), m_name(file)
  {
    if(is_replaceable())
      create_beside();
    errno = 0;
  }

  Whole_file(const Whole_file&) = delete;
  Whole_file& operator=(const Whole_file&) = delete;

  ~Whole_file()
  {
    std::error_code ignored;
    if(m_has_other_name)
      std::filesystem::remove(m_name, ignored);
    Interruption::leftovers[0] = nullptr;
  }

  // where it is to be written
  const std::string& name() const { return m_name; }

  // It is all there. Returns `false` if it cannot get its name. Some files can be written, but not replaced: those that
  // a container has from outside, or those of others in a folder for all.
  bool finish()
  {
    if(! m_has_other_name)
      return true;
    std::error_code error;
    std::filesystem::rename(m_name, m_file, error);
    m_has_other_name = bool(error);
    return ! m_has_other_name || copy_bytes(m_name, m_file.string());
  }

private:
  // Links to nothing would be replaced themselves.
  bool is_replaceable() const
  {
    std::error_code error;
    if(std::filesystem::exists(m_file, error))
      return std::filesystem::is_regular_file(m_file, error) && std::filesystem::hard_link_count(m_file, error) == 1;
    return ! std::filesystem::is_symlink(m_file, error);
  }

  // The name is a whole path, as the current folder may change.
  void create_beside()
  {
    std::error_code error;
    const std::filesystem::path target = weakly_canonical(std::filesystem::absolute(m_file, error), error); // of links
    const std::string name = error ? std::string() : new_file_beside(target);
    if(name.empty())
      return;
    const auto status = std::filesystem::status(target, error);
    if(std::filesystem::exists(status))
      std::filesystem::permissions(name, status.permissions(), error);
    m_file = target;
    m_name = name;
    m_has_other_name = true;
    Interruption::leftovers[0] = m_name.c_str();
  }

  // returns the name of a file that nobody else has; empty if there can be none
  static std::string new_file_beside(const std::filesystem::path& file)
  {
    for(int k = 1; ; ++k)
    {
      std::filesystem::path name = file;
      name.replace_filename(file.stem().string() + ".part" + std::to_string(k) + file.extension().string());
      if(std::FILE* const created = std::fopen(name.string().c_str(), "wx"))
      {
        std::fclose(created);
        return name.string();
      }
      if(errno != EEXIST)
        return std::string();
    }
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WHOLE_FILE_H
