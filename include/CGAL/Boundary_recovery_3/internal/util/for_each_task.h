// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

#ifndef CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_FOR_EACH_TASK_H
#define CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_FOR_EACH_TASK_H

#include <CGAL/license/Boundary_recovery_3.h>

#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Boundary_recovery_3::internal {

// Whether triangulations of this type can be worked on by several threads: numbers with reference counts are not for
// them.
template <typename Tr>
using Concurrency_tag_of = std::conditional_t<std::is_floating_point<typename Tr::Geom_traits::FT>::value,
                                              Parallel_if_available_tag, Sequential_tag>;

inline std::size_t number_of_workers(Sequential_tag) { return 1; }

#ifdef CGAL_LINKED_WITH_TBB

inline std::size_t number_of_workers(Parallel_tag)
{
  return static_cast<std::size_t>((std::max)(1, tbb::this_task_arena::max_concurrency()));
}

// Each thread takes the next task when it is ready, so not more of them are under way than there are threads. What was
// done before the tasks and in them is seen in them and after them, as the atomic numbers also tell ThreadSanitizer,
// which does not look into the TBB.
inline void for_each_in_order(const std::vector<std::size_t>& order, const std::function<void(std::size_t)>& work,
                              const Parallel_tag tag)
{
  std::atomic<std::size_t> next, number_of_ends(0);
  next.store(0, std::memory_order_release);
  const std::size_t concurrency = internal::number_of_workers(tag);
  const auto do_tasks = [&]
  {
    for(std::size_t k = next++; k < order.size(); k = next++)
      work(order[k]);
    ++number_of_ends;
  };
  typedef tbb::blocked_range<std::size_t> Range;
  tbb::parallel_for(Range(0, (std::min)(concurrency, order.size())), [&do_tasks](const Range&) { do_tasks(); },
                    tbb::simple_partitioner());
  number_of_ends.load(std::memory_order_acquire);
}

#endif // CGAL_LINKED_WITH_TBB

inline void for_each_in_order(const std::vector<std::size_t>& order, const std::function<void(std::size_t)>& work,
                              Sequential_tag)
{
  for(const std::size_t task : order)
    work(task);
}

// Does the tasks with these weights, the heaviest one first, at the same time if the tag and the TBB allow for that.
template <typename ConcurrencyTag>
void for_each_task(const std::vector<std::size_t>& weights, const std::function<void(std::size_t)>& work,
                   const ConcurrencyTag tag)
{
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](const std::size_t x, const std::size_t y) { return weights[x] > weights[y]; });
  internal::for_each_in_order(order, work, tag);
}

/*
 * What comes of blocks of work, taken in the order of the blocks, whichever thread is ready first.
 */
template <typename Result, typename Take>
class Results_in_order
{
public:
  explicit Results_in_order(const Take& take) : m_take(take) { }

  // Whether `take` never said no, and never threw.
  bool goes_on() const { return m_goes_on; }

  // By any thread.
  void add(const std::size_t block, Result&& result)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_waiting.emplace(block, std::move(result));
    for(auto first = m_waiting.begin(); m_goes_on && first != m_waiting.end() && first->first == m_number_of_taken;
        first = m_waiting.erase(first), ++m_number_of_taken)
      take(first->second);
  }

private:
  void take(const Result& result)
  {
    try
    {
      m_goes_on = m_take(result);
    }
    catch(...)
    {
      m_goes_on = false;
      throw;
    }
  }

  const Take& m_take;
  std::mutex m_mutex;
  std::map<std::size_t, Result> m_waiting;
  std::size_t m_number_of_taken = 0;
  std::atomic<bool> m_goes_on{ true };
};

// All threads call `look_at(handles)` for blocks of these handles, and one at a time `take(result)` with what comes of
// it, in the order of the blocks. Returns false as soon as `take` does.
template <typename HandleRange, typename Look_at, typename Take, typename ConcurrencyTag>
bool for_each_block(const HandleRange& handles, const Look_at& look_at, const Take& take, const ConcurrencyTag tag)
{
  typedef std::vector<std::decay_t<decltype(*handles.begin())> > Block;
  constexpr std::size_t handles_per_block = 2048; // what they belong to stays in the cache
  Results_in_order<std::decay_t<decltype(look_at(std::declval<const Block&>()))>, Take> results(take);
  std::mutex mutex;
  std::size_t number_of_blocks = 0;
  auto next = handles.begin();
  const auto next_block = [&](Block& block)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    block.clear();
    for(; block.size() < handles_per_block && next != handles.end(); ++next)
      block.push_back(*next);
    return number_of_blocks++;
  };
  const std::vector<std::size_t> tasks(internal::number_of_workers(tag), 1);
  internal::for_each_task(tasks, [&](std::size_t)
  {
    Block block;
    for(std::size_t k = next_block(block); ! block.empty() && results.goes_on(); k = next_block(block))
      results.add(k, look_at(block));
  }, tag);
  return results.goes_on();
}

// Calls `f(handle)` for each of these handles, by any thread.
template <typename HandleRange, typename Function, typename ConcurrencyTag>
void for_each_handle(const HandleRange& handles, const Function& f, const ConcurrencyTag tag)
{
  internal::for_each_block(handles, [&f](const auto& block)
  {
    for(const auto& handle : block)
      f(handle);
    return true;
  }, [](bool) { return true; }, tag);
}

// All threads call `find(handle)`, which returns an optional value, and one at a time calls `take(value)`, in the order
// of the handles.
template <typename HandleRange, typename Find, typename Take, typename ConcurrencyTag>
void take_each(const HandleRange& handles, const Find& find, const Take& take, const ConcurrencyTag tag)
{
  typedef typename decltype(find(*handles.begin()))::value_type Value;
  internal::for_each_block(handles, [&find](const auto& block)
  {
    std::vector<Value> values;
    for(const auto& handle : block)
      if(const auto value = find(handle))
        values.push_back(*value);
    return values;
  },
  [&take](const std::vector<Value>& values)
  {
    for(const Value& value : values)
      take(value);
    return true;
  }, tag);
}

// Does work by at most so many threads, and no more than the TBB allows for; 0: by as many as the caller's arena has.
template <typename Work>
void with_threads([[maybe_unused]] const std::size_t number_of_threads, const Work& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(number_of_threads > 0)
  {
    const std::size_t most = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    tbb::task_arena arena(static_cast<int>((std::min)(number_of_threads, most)));
    return arena.execute(work);
  }
#endif
  work();
}

/*
 * Stands between the tasks of several threads and the visitor, which is called by one of them at a time. It is not told
 * of cells, since those that tasks change are not its.
 */
template <typename Tr>
class Task_visitor_3
  : public Mesh_visitor_3<Tr>
{
public:
  explicit Task_visitor_3(Mesh_visitor_3<Tr>& visitor) : m_visitor(visitor) { }

  // From now on, progress is that of tasks with this weight, which are one of several rounds of the phase.
  void begin(const Phase phase, const std::size_t round, const std::size_t number_of_rounds,
             const std::size_t weight)
  {
    begin(phase, round * weight, number_of_rounds * weight);
  }

  // The same where so much of the phase is done, of about that much.
  void begin(const Phase phase, const std::size_t done, const std::size_t total)
  {
    m_phase = phase;
    m_done = done;
    m_total = total;
  }

  void end_task(const std::size_t weight)
  {
    do_alone([&]
    {
      m_done += weight;
      m_visitor.on_progress(m_phase, m_done, (std::max)(m_done, m_total));
    });
  }

  // Something that has to do with the visitor, while no other thread does.
  template <typename Work>
  void do_alone(const Work& work)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    work();
  }

  // Whether it has said no.
  bool is_stopped() const { return m_is_stopped; }

  // Threads that find the visitor busy go on for now.
  bool go_further() override
  {
    const std::unique_lock<std::mutex> lock(m_mutex, std::try_to_lock);
    if(lock && ! m_is_stopped)
      m_is_stopped = ! m_visitor.go_further();
    return ! m_is_stopped;
  }

protected:
  Mesh_visitor_3<Tr>& m_visitor;
  std::mutex m_mutex;

private:
  std::atomic<bool> m_is_stopped{ false };
  Phase m_phase = Phase::field_point_insertion;
  std::size_t m_done = 0;
  std::size_t m_total = 0;
};

// The same where the cells that tasks change are the visitor's.
template <typename Tr>
class Part_visitor_3 final
  : public Task_visitor_3<Tr>
{
  typedef Task_visitor_3<Tr> Base;
  typedef typename Mesh_visitor_3<Tr>::Cells Cells;
  using Base::m_mutex;
  using Base::m_visitor;

public:
  explicit Part_visitor_3(Mesh_visitor_3<Tr>& visitor) : Base(visitor), m_watches_cells(visitor.watches_cells()) { }

  void before_cells_removal(const Cells& cells) override
  {
    tell([&] { m_visitor.before_cells_removal(cells); });
  }

  void after_cells_creation(const Cells& cells) override
  {
    tell([&] { m_visitor.after_cells_creation(cells); });
  }

  bool watches_cells() const override { return m_watches_cells; }

private:
  template <typename Tell>
  void tell(const Tell& tell)
  {
    if(! m_watches_cells)
      return;
    const std::lock_guard<std::mutex> lock(m_mutex);
    tell();
  }

  const bool m_watches_cells;
};

} // namespace CGAL::Boundary_recovery_3::internal

#endif // CGAL_BOUNDARY_RECOVERY_3_INTERNAL_UTIL_FOR_EACH_TASK_H
