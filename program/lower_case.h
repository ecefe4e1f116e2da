#ifndef BOUNDARY_RECOVERY_3_PROGRAM_LOWER_CASE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_LOWER_CASE_H

#include <cctype>
#include <cstddef>
#include <string>

inline std::string lower_case(std::string text)
{
  for(char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

inline std::string lower_case_extension(const std::string& file)
{
  const std::size_t dot = file.rfind('.');
  return dot == std::string::npos ? std::string() : lower_case(file.substr(dot));
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_LOWER_CASE_H
