#ifndef BOUNDARY_RECOVERY_3_PROGRAM_WHOLE_FILE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_WHOLE_FILE_H

#include "interruption.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
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
    std::filesystem::remove(file, error);
  if(is_full)
    errno = ENOSPC;
  return ! is_full;
}

// A file that is there as a whole, or as it was before: it is written under another name, with the same extension,
// beside it, and gets its name at last. What is no ordinary file, as a device or a pipe, is written as it is, and so is
// a file in a folder that takes no new ones.
class Whole_file
{
  std::filesystem::path m_file;
  std::string m_name; // under which it is written

public:
  explicit Whole_file(const std::string& file) : m_file(file), m_name(file)
  {
    std::error_code error;
    const auto status = std::filesystem::status(m_file, error);
    if(std::filesystem::exists(status) && ! std::filesystem::is_regular_file(status))
      return;
    const std::filesystem::path target = std::filesystem::weakly_canonical(m_file, error); // of links
    if(error)
      return;
    const std::string name = unused_name(target);
    if(! std::ofstream(name).is_open())
      return;
    if(std::filesystem::exists(status))
      std::filesystem::permissions(name, status.permissions(), error);
    m_file = target;
    m_name = name;
    Interruption::half_file = m_name.c_str();
  }

  Whole_file(const Whole_file&) = delete;
  Whole_file& operator=(const Whole_file&) = delete;

  ~Whole_file()
  {
    std::error_code ignored;
    if(is_other_name())
      std::filesystem::remove(m_name, ignored);
    Interruption::half_file = nullptr;
  }

  // where it is to be written
  const std::string& name() const { return m_name; }

  // It is all there. Returns `false` if it cannot get its name.
  bool finish()
  {
    std::error_code error;
    if(is_other_name())
      std::filesystem::rename(m_name, m_file, error);
    if(error)
      return false;
    Interruption::half_file = nullptr; // before the name goes
    m_name = m_file.string();
    return true;
  }

private:
  bool is_other_name() const { return m_name != m_file.string(); }

  static std::string unused_name(const std::filesystem::path& file)
  {
    for(int k = 1; ; ++k)
    {
      std::filesystem::path name = file;
      name.replace_filename(file.stem().string() + ".part" + std::to_string(k) + file.extension().string());
      std::error_code ignored;
      if(! std::filesystem::exists(std::filesystem::symlink_status(name, ignored)))
        return name.string();
    }
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_WHOLE_FILE_H
