#ifndef BOUNDARY_RECOVERY_3_PROGRAM_INTERRUPTION_H
#define BOUNDARY_RECOVERY_3_PROGRAM_INTERRUPTION_H

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdio>

#ifndef _WIN32
#include <unistd.h>
#endif

// What is put in order when the program is interrupted: there is no half file, and no progress bar, then.
struct Interruption
{
  // files and empty folders that are removed in this order: an output, and those of Gmsh
  static inline std::array<std::atomic<const char*>, 4> leftovers = { };
  static inline std::atomic<std::size_t> length_of_line = 0;  // of what stands in the last line of the terminal

  // What ends the program by default still does so, with the exit status that shells expect. What is ignored stays so.
  static void prepare()
  {
    for(const int signal : signals)
      if(std::signal(signal, &end) == SIG_IGN)
        std::signal(signal, SIG_IGN);
  }

private:
#ifdef _WIN32
  static constexpr std::array<int, 2> signals = {{ SIGINT, SIGTERM }};

  static void clear_line() { }
  static void remove(const char* const name) { std::remove(name); }
#else
  static constexpr std::array<int, 3> signals = {{ SIGINT, SIGTERM, SIGHUP }};
  static constexpr std::size_t length_of_echo = 2; // that the terminal shows of Ctrl-C

  // These functions are safe here.
  static void clear_line()
  {
    char text[256];
    const std::size_t n = (std::min)(length_of_line + length_of_echo, sizeof(text) - 2);
    std::fill_n(text, n + 2, ' ');
    text[0] = text[n + 1] = '\r';
    [[maybe_unused]] const auto written = write(STDOUT_FILENO, text, n + 2);
  }

  static void remove(const char* const name)
  {
    if(unlink(name) != 0)
      rmdir(name);
  }
#endif

  static void end(const int signal)
  {
    for(const auto& leftover : leftovers)
      if(const char* const name = leftover)
        remove(name);
    if(length_of_line > 0)
      clear_line();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_INTERRUPTION_H
