#ifndef BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_ESTIMATE_H
#define BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_ESTIMATE_H

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>

// The steps of a run of the mesher, as the user is told of them.
enum Step { reading, insertion, recovery, marking, forecast, filling, improvement, measuring, writing };

constexpr std::size_t number_of_steps = 9;
constexpr std::array<const char*, number_of_steps> names_of_steps = {{
  "reading", "insertion", "recovery", "regions", "forecast", "filling", "improvement", "measuring", "writing" }};

// Which share of its time a run has behind it, from the durations that are expected of its steps, the time that was
// really needed so far, and the share of the present step.
class Progress_estimate
{
  typedef std::chrono::steady_clock Clock;

  static constexpr double least_sample = 0.1; // seconds that the machine is taken for one as expected
  static constexpr double tiny = 1e-9;

  const Clock::time_point m_start = Clock::now();
  std::array<double, number_of_steps> m_expected{}, m_seconds{};
  Step m_step = reading;
  double m_begin = 0;     // of the step, in seconds
  double m_part = 0;      // of the step
  double m_rest = 0;      // of the step, in seconds, as it was at `m_time_of_rest`
  double m_time_of_rest = 0;
  double m_last_share = 0;

public:
  // `seconds` on a machine as fast as one usually is; how much slower this one is comes out in the first steps
  void expect(const Step step, const double seconds)
  {
    m_expected[step] = seconds;
    if(step == m_step)
      set_rest_of_step();
  }

  void begin(const Step step)
  {
    const double now = seconds();
    m_seconds[m_step] += now - m_begin;
    m_step = step;
    m_begin = now;
    m_part = 0;
    set_rest_of_step();
  }

  void set_part_of_step(const double part)
  {
    m_part = part;
    set_rest_of_step();
  }

  Step step() const { return m_step; }

  // Never falls. As long as nothing new is known of the step, the rest of it shrinks with time, but is never over.
  double share()
  {
    const double now = seconds(), slowness = this->slowness();
    double rest = m_rest * m_rest / (m_rest + now - m_time_of_rest + tiny);
    for(std::size_t step = m_step + 1; step < number_of_steps; ++step)
      rest += slowness * m_expected[step];
    m_last_share = (std::max)(m_last_share, now / (now + rest + tiny));
    return m_last_share;
  }

private:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  // of the machine, judged by those steps whose duration hardly depends on the shape
  double slowness() const
  {
    double expected = least_sample, needed = least_sample;
    for(const Step step : { insertion, marking, forecast, filling })
      if(step < m_step)
      {
        expected += m_expected[step];
        needed += m_seconds[step];
      }
    return needed / expected;
  }

  // At first what was expected counts, then more and more what the part of the step says.
  void set_rest_of_step()
  {
    m_time_of_rest = seconds();
    const double needed = m_time_of_rest - m_begin, expected = slowness() * m_expected[m_step];
    const double weight = (std::min)(1., 1.5 * m_part);
    const double by_part = m_part > 0 ? needed * (1 - m_part) / m_part : 0;
    m_rest = weight * by_part + (1 - weight) * (std::max)(0., expected - needed);
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_PROGRESS_ESTIMATE_H
