#ifndef BOUNDARY_RECOVERY_3_PROGRAM_TERMINAL_H
#define BOUNDARY_RECOVERY_3_PROGRAM_TERMINAL_H

#include <cstddef>

#ifdef _WIN32
#include <io.h>
#else
#include <sys/ioctl.h>
#include <unistd.h>
#endif

inline bool stdout_is_terminal()
{
#ifdef _WIN32
  return _isatty(1) != 0;
#else
  return isatty(1) != 0;
#endif
}

// of the terminal that the standard output goes to; 80 if nobody knows
inline std::size_t terminal_columns()
{
#ifndef _WIN32
  winsize size;
  if(ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    return size.ws_col;
#endif
  return 80;
}

#endif // BOUNDARY_RECOVERY_3_PROGRAM_TERMINAL_H
