#ifndef BOUNDARY_RECOVERY_3_PROGRAM_LIVE_PROGRESS_BAR_H
#define BOUNDARY_RECOVERY_3_PROGRAM_LIVE_PROGRESS_BAR_H

#include "progress_bar.h"
#include "progress_estimate.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <ostream>
#include <thread>

// A bar with the share of an estimate, which a thread draws again and again: long steps tell nothing for a while. What
// takes less than a blink is not shown. Nothing is drawn before the first step, and after `hide()` until a step tells
// something.
template <typename Estimate>
class Live_progress_bar
{
  static constexpr std::chrono::milliseconds blink{100}, pause{30};

  Estimate m_estimate;
  Progress_bar m_bar;
  bool m_is_hidden = true, m_is_over = false;
  std::mutex m_mutex; // of all above
  std::condition_variable m_end;
  std::thread m_thread;

public:
  // `is_on` says whether there is anybody to look at it
  template <typename Argument>
  Live_progress_bar(std::ostream& os, const bool is_on, const Argument& argument)
    : m_estimate(argument), m_bar(os)
  {
    if(is_on)
      m_thread = std::thread([this] { draw_until_end(); });
  }

  Live_progress_bar(const Live_progress_bar&) = delete;
  Live_progress_bar& operator=(const Live_progress_bar&) = delete;

  ~Live_progress_bar()
  {
    hide();
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_over = true;
    }
    m_end.notify_one();
    if(m_thread.joinable())
      m_thread.join();
  }

  // `f` tells the estimate something new, if anybody looks at it
  template <typename Function>
  void tell(const Function& f)
  {
    if(! m_thread.joinable())
      return;
    const std::lock_guard<std::mutex> lock(m_mutex);
    f(m_estimate);
    m_is_hidden = false;
  }

  // to be called before anything else is printed
  void hide()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_is_hidden = true;
    m_bar.clear();
  }

private:
  void draw_until_end()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    const auto is_over = [this] { return m_is_over; };
    for(auto wait = blink; ! m_end.wait_for(lock, wait, is_over); wait = pause)
      if(! m_is_hidden)
        m_bar.draw(names_of_steps[m_estimate.step()], m_estimate.share());
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_LIVE_PROGRESS_BAR_H
