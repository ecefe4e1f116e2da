// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors

// The tools that know nothing of geometry: ranges, hash tables of simplices, matrices of bits, and runs: their context,
// and who stands between them and a visitor.

#undef NDEBUG

#include "random_numbers_br3.h"
#include "stopping_visitor_br3.h"

#include <CGAL/Boundary_recovery_3/Meshing_visitor_3.h>
#include <CGAL/Boundary_recovery_3/Size_source_3.h>
#include <CGAL/Boundary_recovery_3/enumerations.h>
#include <CGAL/Boundary_recovery_3/internal/input/Constraint_intersections_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/Recovery_context.h>
#include <CGAL/Boundary_recovery_3/internal/util/Simplex_index_3.h>
#include <CGAL/Boundary_recovery_3/internal/util/bare_point.h>
#include <CGAL/Boundary_recovery_3/internal/util/bits.h>
#include <CGAL/Boundary_recovery_3/internal/util/contains.h>
#include <CGAL/Boundary_recovery_3/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace BR3 = CGAL::Boundary_recovery_3;
namespace internal = BR3::internal;

// All that a visitor needs of a triangulation are its cell handles: here, numbers.
struct Numbered_cells
{
  typedef int Cell_handle;
};

typedef internal::Mesh_visitor_3<Numbered_cells>      Mesh_visitor;
typedef internal::Recording_visitor_3<Numbered_cells> Recording_visitor;
typedef internal::Recovery_context<Numbered_cells>    Context;
typedef br3_test::Stopping_visitor<Numbered_cells>    Stopping_visitor;

// Their names are different words, and the only ones; what is written is the name.
template <typename Enumeration>
void test_names(const int number)
{
  std::set<std::string> names;
  for(int i = 0; i < number; ++i)
  {
    std::ostringstream os;
    os << static_cast<Enumeration>(i);
    assert(os.str() == to_string(static_cast<Enumeration>(i)) && ! os.str().empty());
    assert(names.insert(os.str()).second);
  }
  assert(std::string(to_string(static_cast<Enumeration>(number))).empty());
}

void test_enumerations()
{
  test_names<BR3::Recovery_mode>(3);
  test_names<BR3::Recovery_effort>(2);
  test_names<BR3::Recovery_status>(4);
  test_names<BR3::Phase>(25);
  test_names<BR3::Input_defect_kind>(16);
  test_names<BR3::Meshing_status>(6);
  test_names<BR3::Improvement_effort>(3);
  test_names<BR3::Bad_cell_reason>(4);
  test_names<BR3::Size_source_3<CGAL::Simple_cartesian<double>>::Shape>(4);
}

struct Visitor_of_references
{
  void on_phase_begin(const CGAL::Boundary_recovery_3::Phase&) { }
  void on_phase_end(CGAL::Boundary_recovery_3::Phase_report) { }
  template <typename Phase>
  void on_progress(Phase, double, double) { }
  int go_further() { return 1; }
};

struct Visitor_that_is_never_asked
  : public CGAL::Default_meshing_visitor_3
{
private:
  using CGAL::Default_meshing_visitor_3::go_further;
};

struct Visitor_of_numbers
  : public CGAL::Default_meshing_visitor_3
{
  void on_phase_begin(std::string) { }
};

void test_which_visitors_are_refused()
{
  static_assert(internal::Is_meshing_visitor<CGAL::Default_meshing_visitor_3>::value, "");
  static_assert(internal::Is_meshing_visitor<Visitor_of_references>::value, "");
  static_assert(! internal::Is_meshing_visitor<Visitor_that_is_never_asked>::value, "");
  static_assert(! internal::Is_meshing_visitor<Visitor_of_numbers>::value, "");
  static_assert(! internal::Is_meshing_visitor<int>::value, "");
}

void test_contains()
{
  const std::array<int, 3> items = {{ 2, 3, 5 }};
  const std::vector<int> none;
  for(int i = 0; i < 7; ++i)
  {
    assert(internal::contains(items, i) == (i == 2 || i == 3 || i == 5));
    assert(! internal::contains(none, i));
  }
}

// Against std::map, with simplices that come again, one by one and many at a time, and with reserve() in between.
template <std::size_t N>
void test_simplex_index(const unsigned seed, const int number_of_vertices)
{
  typedef internal::Simplex_index_3<const double*, N> Index;
  typedef std::array<const double*, N> Simplex;
  std::vector<double> vertices(static_cast<std::size_t>(number_of_vertices)); // any addresses will do
  std::mt19937 rng(seed);
  Index index;
  std::map<Simplex, std::size_t> expected; // by sorted simplices
  std::vector<Simplex> queries, inserted_simplices;
  const auto sorted = [](Simplex s)
  {
    std::sort(s.begin(), s.end(), std::less<const double*>());
    return s;
  };
  const auto expected_number = [&](const Simplex& s)
  {
    const auto it = expected.find(sorted(s));
    return it == expected.end() ? Index::none : it->second;
  };
  const auto check_many = [&]
  {
    std::vector<std::size_t> numbers(1);
    index.look_up(queries, numbers);
    assert(numbers.size() == queries.size());
    for(std::size_t k = 0; k < queries.size(); ++k)
      assert(numbers[k] == expected_number(queries[k]));
  };
  for(int i = 0; i < 4000; ++i)
  {
    Simplex s;
    for(const double*& p : s)
      p = &vertices[static_cast<std::size_t>(br3_test::random_int(rng, number_of_vertices))];
    queries.push_back(s);
    assert(index[s] == expected_number(s));
    if(br3_test::random_int(rng, 3) == 0)
    {
      const bool is_new = expected_number(s) == Index::none;
      const auto inserted = index.insert(s);
      assert(inserted.second == is_new);
      assert(inserted.first == expected.emplace(sorted(s), expected.size()).first->second);
      if(is_new)
        inserted_simplices.push_back(s);
    }
    if(br3_test::random_int(rng, 500) == 0)
    {
      index.reserve(static_cast<std::size_t>(br3_test::random_int(rng, 3000)));
      check_many();
    }
    assert(index.size() == expected.size());
  }
  check_many();
  assert(index.keys() == inserted_simplices);

  index.clear();
  assert(index.size() == 0 && index[queries.back()] == index.none);
  for(const bool is_new : { true, false })
    assert(index.insert(queries.back()) == std::make_pair(std::size_t(0), is_new));
}

template <typename Simplex>
bool is_same_but_for_beginning(Simplex s, const Simplex& t)
{
  for(std::size_t k = 0; k < s.size() && s != t; ++k)
    std::rotate(s.begin(), s.begin() + 1, s.end());
  return s == t;
}

// All pairs of simplices with N vertices, which may be the same ones.
template <std::size_t N>
void test_permutations()
{
  std::vector<std::array<std::size_t, N> > simplices(1);
  for(std::size_t i = 0; i < N; ++i)
  {
    std::vector<std::array<std::size_t, N> > longer;
    for(auto s : simplices)
      for(s[i] = 0; s[i] < N; ++s[i])
        longer.push_back(s);
    simplices = longer;
  }
  for(const auto& s : simplices)
    for(const auto& t : simplices)
    {
      assert(internal::is_permutation(s, t) == std::is_permutation(s.begin(), s.end(), t.begin()));
      if constexpr(N == 3)
        assert(internal::has_repeated_vertex(s) || internal::is_rotation(s, t) == is_same_but_for_beginning(s, t));
    }
  for(const auto& s : simplices)
    assert(internal::has_repeated_vertex(s) == (std::set<std::size_t>(s.begin(), s.end()).size() < N));
}

// Numbers whose hash values collide: in all bits, in those that decide on the slot, or in those that are in it.
void test_colliding_hash_values()
{
  const std::array<std::uint64_t (*)(std::uint64_t), 3> hashes = {{
    [](std::uint64_t) { return std::uint64_t(7); },
    [](const std::uint64_t i) { return i << 32; },
    [](const std::uint64_t i) { return i; }
  }};
  for(const auto hash : hashes)
  {
    internal::Hash_index<std::uint64_t, std::uint64_t (*)(std::uint64_t), std::equal_to<std::uint64_t> > index(hash);
    index.reserve(0);
    assert(index[0] == index.none);
    for(const std::uint64_t i : { 5, 3, 5, 0, 3, 200, 0 })
      index.insert(i);
    assert((index.keys() == std::vector<std::uint64_t>{ 5, 3, 0, 200 }));
    for(std::uint64_t i = 0; i < 300; ++i)
      index.insert(i);
    assert(index.size() == 300 && index[0] == 2 && index[4] == 6 && index[299] == 299 && index[300] == index.none);
  }
}

void test_bits()
{
  std::mt19937 rng(31);
  for(int round = 0; round < 1000; ++round)
  {
    std::set<int> expected;
    internal::Bits bits = 0;
    for(int k = round % 8 * round % 64; k >= 0; --k)
      bits |= internal::bit(*expected.insert(br3_test::random_int(rng, 64)).first);
    const int i = br3_test::random_int(rng, 64);
    assert(internal::has_bit(bits, i) == (expected.count(i) == 1));
    assert(internal::number_of_bits(bits) == static_cast<int>(expected.size()));
    assert(internal::is_single_bit(bits) == (expected.size() == 1));
    assert(internal::lowest_bit(bits) == *expected.begin());
    const auto next = expected.upper_bound(i);
    assert(internal::next_bit_on_circle(bits, i) == (next == expected.end() ? *expected.begin() : *next));
    assert((internal::bits_before(i) | internal::bits_after(i)) == ~internal::bit(i));
    std::vector<int> elements;
    internal::for_each_bit(bits, [&](const int k) { elements.push_back(k); });
    assert(std::equal(elements.begin(), elements.end(), expected.begin(), expected.end()));
    assert(internal::any_of_bits(bits, [&](const int k) { return k == i; }) == (expected.count(i) == 1));
  }
}

void test_bit_matrix()
{
  std::mt19937 rng(5);
  for(const std::size_t n : { 1, 63, 64, 65, 200 })
  {
    internal::Bit_matrix matrix;
    matrix.assign(3, n);
    std::array<std::set<std::size_t>, 3> expected;
    for(std::size_t k = 0; k < n; ++k)
    {
      const std::size_t row = static_cast<std::size_t>(br3_test::random_int(rng, 3));
      const std::size_t column = static_cast<std::size_t>(br3_test::random_int(rng, static_cast<int>(n)));
      matrix.set(row, column);
      expected[row].insert(column);
    }
    for(std::size_t row = 0; row < 3; ++row)
    {
      std::vector<std::size_t> columns;
      matrix.for_each([&](const std::size_t w) { return matrix.word(row, w); },
                      [&](const std::size_t column) { columns.push_back(column); });
      assert(std::equal(columns.begin(), columns.end(), expected[row].begin(), expected[row].end()));
      for(std::size_t k = 0; k < n; ++k)
      {
        assert(matrix(row, k) == (expected[row].count(k) == 1));
        assert(matrix.any_of([&](const std::size_t w) { return matrix.word(row, w); },
                             [&](const std::size_t column) { return column == k; }) == matrix(row, k));
      }
    }
  }
}

// --- visitors of any type -------------------------------------------------------------------------------------------

template <typename CellRange>
void test_cell_span(const CellRange& cells)
{
  const internal::Cell_span<int> span(cells);
  assert(span.size() == cells.size() && span.empty() == cells.empty() && span.data() == cells.data());
  assert(std::equal(span.begin(), span.end(), cells.begin(), cells.end()));
}

void test_cell_spans()
{
  test_cell_span(std::vector<int>{ 3, 1, 2 });
  test_cell_span(std::vector<int>());
  test_cell_span(std::array<int, 2>{{ 5, 4 }});
  test_cell_span(std::array<int, 0>());
  typedef boost::container::small_vector<int, 2> Small_vector;
  test_cell_span(Small_vector{ 1, 2 });
  test_cell_span(Small_vector{ 1, 2, 3 }); // too many for its own memory
  const std::vector<int> cells = { 7, 8 };
  test_cell_span(internal::Cell_span<int>(cells));
}

// Writes down all calls, also those of its copies, and says no to the second question.
struct Writing_visitor
{
  explicit Writing_visitor(std::ostream& os) : os(&os) { }

  void on_phase_begin(const BR3::Phase phase) { *os << "begin " << phase << '\n'; }

  void on_phase_end(const BR3::Phase_report& report)
  {
    *os << "end " << report.phase << ' ' << report.lost_edges << ' ' << report.lost_facets << ' '
        << report.number_of_vertices << ' ' << report.number_of_cells << ' ' << report.number_of_holes << '\n';
  }

  void on_progress(const BR3::Phase phase, const std::size_t done, const std::size_t total)
  {
    *os << "progress " << phase << ' ' << done << ' ' << total << '\n';
  }

  bool go_further()
  {
    *os << "question\n";
    return ++number_of_questions != 2;
  }

  template <typename CellRange>
  void before_cells_removal(const CellRange& cells) { write("removal", cells); }

  template <typename CellRange>
  void after_cells_creation(const CellRange& cells) { write("creation", cells); }

  template <typename CellRange>
  void write(const char* const name, const CellRange& cells)
  {
    *os << name << " of " << cells.size();
    for(const int c : cells)
      *os << ' ' << c;
    *os << '\n';
  }

  std::ostream* os;
  int number_of_questions = 0;
};

BR3::Phase_report report_of(const BR3::Phase phase)
{
  BR3::Phase_report report;
  report.phase = phase;
  report.lost_edges = 1;
  report.lost_facets = 2;
  report.number_of_vertices = 3;
  report.number_of_cells = 4;
  report.number_of_holes = 5;
  return report;
}

// One call of each kind, some with several types of arguments.
template <typename Visitor>
void call(Visitor& visitor)
{
  visitor.on_phase_begin(BR3::Phase::search);
  visitor.on_progress(BR3::Phase::search, 6, 7);
  visitor.on_phase_end(report_of(BR3::Phase::search));
  visitor.on_phase_begin(BR3::Phase::hole_filling);
  assert(visitor.go_further());
  visitor.before_cells_removal(std::vector<int>{ 3, 1, 2 });
  visitor.after_cells_creation(boost::container::small_vector<int, 1>{ 5, 4 });
  visitor.before_cells_removal(std::array<int, 1>{{ 9 }});
  visitor.after_cells_creation(std::vector<int>());
  visitor.on_phase_end(report_of(BR3::Phase::hole_filling));
}

// What a visitor writes if nobody stands in between.
std::string expected_text()
{
  std::ostringstream os;
  Writing_visitor visitor(os);
  call(visitor);
  assert(! visitor.go_further());
  return os.str();
}

// All calls come through, to the visitor itself or to a copy, and its answers come back.
void test_any_visitor(Mesh_visitor& any_visitor, std::ostringstream& os)
{
  os.str("");
  call(any_visitor);
  assert(! any_visitor.go_further() && any_visitor.go_further());
  assert(os.str() == expected_text() + "question\n");
}

void test_any_visitors()
{
  namespace parameters = CGAL::parameters;
  std::ostringstream os;
  Writing_visitor of_reference(os), of_copy(os), of_parameter(os);
  internal::Any_visitor_3<Numbered_cells, Writing_visitor&> with_reference(of_reference);
  test_any_visitor(with_reference, os);
  assert(of_reference.number_of_questions == 3);
  internal::Any_visitor_3<Numbered_cells, Writing_visitor> with_copy{ Writing_visitor(of_copy) };
  test_any_visitor(with_copy, os);
  assert(of_copy.number_of_questions == 0);

  auto passed_copy = internal::mesh_visitor<Numbered_cells>(parameters::visitor(of_parameter));
  test_any_visitor(passed_copy, os);
  assert(of_parameter.number_of_questions == 0);
  auto passed_reference = internal::mesh_visitor<Numbered_cells>(parameters::visitor(std::ref(of_parameter)));
  test_any_visitor(passed_reference, os);
  assert(of_parameter.number_of_questions == 3);

  // one that is plain already
  Mesh_visitor& plain = with_reference;
  of_reference.number_of_questions = 0;
  auto passed_plain = internal::mesh_visitor<Numbered_cells>(parameters::visitor(std::ref(plain)));
  test_any_visitor(passed_plain, os);

  // those that do nothing
  Mesh_visitor silent;
  auto not_passed = internal::mesh_visitor<Numbered_cells>(parameters::default_values());
  call(silent);
  call(not_passed);
  assert(silent.go_further() && not_passed.go_further());
}

// It hands on all calls, keeps the reports that are not of a recovery, and the visitor's no is final.
void test_recording_visitor()
{
  std::ostringstream os;
  Writing_visitor visitor(os);
  internal::Any_visitor_3<Numbered_cells, Writing_visitor&> any_visitor(visitor);
  std::vector<BR3::Phase_report> reports;
  Recording_visitor recorder(any_visitor, reports);
  call(recorder);
  for(int i = 0; i < 5; ++i)
    assert(! recorder.go_further());
  assert(os.str() == expected_text() && visitor.number_of_questions == 2);
  assert(reports.size() == 1 && reports[0].phase == BR3::Phase::hole_filling);
  assert(reports[0].number_of_holes == 5 && reports[0].number_of_cells == 4);
  for(int i = 0; i < 25; ++i)
  {
    const BR3::Phase phase = static_cast<BR3::Phase>(i);
    const std::size_t before = reports.size();
    recorder.on_phase_end(report_of(phase));
    assert(reports.size() == before + (internal::is_of_recovery(phase) ? 0 : 1));
  }
}

// --- the context of a run -------------------------------------------------------------------------------------------

// A phase begins, does its work, is described, and ends; the time is that of the work.
void test_phases()
{
  std::ostringstream os;
  Writing_visitor visitor(os);
  internal::Any_visitor_3<Numbered_cells, Writing_visitor&> any_visitor(visitor);
  Context context(any_visitor);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  std::vector<BR3::Phase_report> reports;
  context.run(BR3::Phase::hole_recovery, [&]
  {
    os << "work\n";
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  },
  [&](BR3::Phase_report& report)
  {
    os << "description\n";
    assert(report.phase == BR3::Phase::hole_recovery && report.seconds >= .01);
    assert(report.seconds <= context.seconds() - .02);
    report.number_of_holes = 8;
    reports.push_back(report);
  });
  std::ostringstream expected;
  expected << "begin " << BR3::Phase::hole_recovery << "\nwork\ndescription\n"
           << "end " << BR3::Phase::hole_recovery << " 0 0 0 0 8\n";
  assert(os.str() == expected.str() && reports.size() == 1);
}

// The visitor's no is final: it is not asked again.
void test_cancelling()
{
  Stopping_visitor visitor;
  visitor.last_question = 2;
  Context context(visitor);
  assert(&context.visitor() == &visitor && ! context.is_stopped());
  assert(context.go_further() && context.go_further() && ! context.is_stopped());
  for(int i = 0; i < 3000; ++i)
    assert(! (i % 2 == 0 ? context.go_further() : context.go_further_after_short_step()) && context.is_stopped());
  assert(visitor.number_of_questions == 3);
}

// Of short steps, each 1024th one leads to a question.
void test_short_steps()
{
  Stopping_visitor visitor;
  visitor.last_question = 3;
  Context context(visitor);
  for(std::size_t i = 1; i < 4 * 1024; ++i)
  {
    assert(context.go_further_after_short_step() && ! context.is_stopped());
    assert(visitor.number_of_questions == i / 1024);
  }
  assert(! context.go_further_after_short_step() && context.is_stopped());
}

// Of long steps, each 16th one leads to a question, and the clock is looked at after each.
void test_long_steps()
{
  Stopping_visitor visitor;
  visitor.last_question = 3;
  Context context(visitor);
  for(std::size_t i = 1; i < 4 * 16; ++i)
  {
    assert(context.go_further_after_long_step() && ! context.is_stopped());
    assert(visitor.number_of_questions == i / 16);
  }
  assert(! context.go_further_after_long_step() && context.is_stopped());

  Stopping_visitor patient;
  Context late(patient);
  late.set_maximum_running_time(0);
  assert(! late.go_further_after_long_step() && late.is_stopped() && patient.number_of_questions == 0);
}

// What only tells of the work has a moment left after a no.
void test_finishing()
{
  Stopping_visitor visitor;
  visitor.last_question = 1;
  Context context(visitor);
  for(std::size_t i = 1; i <= 2 * 1024 + 1; ++i)
    assert(context.can_finish_after_short_step());
  assert(context.is_stopped() && visitor.number_of_questions == 2);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  std::size_t number_of_steps = 1;
  while(context.can_finish_after_short_step())
    ++number_of_steps;
  assert(number_of_steps < 1024);
}

// Nothing but a time that is not over yet lets the run go on.
void test_running_time()
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for(const double seconds : { infinity, 1e6, 0., -1., nan })
  {
    Stopping_visitor visitor;
    Context context(visitor);
    context.set_maximum_running_time(seconds);
    assert(context.go_further() == (seconds > 0) && context.is_stopped() == ! (seconds > 0));
    assert((context.seconds_left() > 0) == (seconds > 0) && ! (context.seconds_left() > seconds));
    assert(visitor.number_of_questions == (seconds > 0 ? 1 : 0));
  }
  Stopping_visitor visitor;
  Context context(visitor);
  assert(context.seconds_left() == infinity);
  const double start = context.seconds();
  context.set_maximum_running_time(start + .01);
  while(context.go_further())
    assert(context.seconds() >= start);
  assert(start >= 0 && context.seconds() >= start + .01);
}

// The smallest of them, in whatever order they come; what is not wanted need not be inserted.
void test_smallest_elements()
{
  std::mt19937 rng(7);
  const std::size_t n = 1000;
  std::vector<std::size_t> all(n);
  std::iota(all.begin(), all.end(), 0);
  for(const std::size_t max_number : { std::size_t(0), std::size_t(1), std::size_t(2), std::size_t(99), n - 1, n, n + 1,
                                       std::size_t(-1) })
    for(int k = 0; k < 4; ++k)
    {
      if(k < 2)
        std::shuffle(all.begin(), all.end(), rng);
      else
        std::sort(all.begin(), all.end(), [k](const auto i, const auto j) { return k == 2 ? i < j : j < i; });
      internal::Smallest_elements<std::size_t> everything(max_number), wanted(max_number);
      for(const std::size_t x : all)
      {
        everything.insert(x);
        if(wanted.is_wanted(x))
          wanted.insert(x);
      }
      std::vector<std::size_t> expected((std::min)(n, max_number));
      std::iota(expected.begin(), expected.end(), 0);
      assert(everything.sorted() == expected && wanted.sorted() == expected);
      assert(everything.number_of_insertions() == n);
      assert(wanted.number_of_insertions() <= n && wanted.number_of_insertions() >= (std::min)(n, max_number));
      assert((wanted.number_of_insertions() > max_number) == (n > max_number));
    }
}

// Once there is more work than this, the question is asked, once for each time that it is asked for; whether the
// recovery goes on then depends on the answer only.
void test_examination()
{
  for(const bool is_hopeless : { false, true })
  {
    Stopping_visitor visitor;
    Context context(visitor);
    context.add_work(1000); // nobody wants to know
    std::size_t number_of_examinations = 0;
    const auto second = [&]
    {
      ++number_of_examinations;
      assert(context.work() == 2001);
      if(is_hopeless)
        context.refute();
    };
    context.examine_after(1500, [&] { ++number_of_examinations; context.examine_after(2000, second); });
    context.add_work(500);
    assert(number_of_examinations == 0);
    for(const std::size_t work : { 1, 499, 1 })
    {
      assert(context.go_further());
      context.add_work(work);
    }
    assert(number_of_examinations == 2);
    context.add_work(5000);
    assert(number_of_examinations == 2);
    assert(context.go_further() == ! is_hopeless && context.is_refuted() == is_hopeless && ! context.is_stopped());
    assert(context.go_further_after_short_step() == ! is_hopeless);
  }
}

// A point without a weight is taken as it is, and not copied.
void test_bare_point()
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  const Kernel::Point_3 p(1, 2, 3);
  const Kernel::Weighted_point_3 weighted(p, 4);
  assert(&internal::bare_point<Kernel::Point_3>(p) == &p);
  assert(internal::bare_point<Kernel::Point_3>(weighted) == p);
}

int main()
{
  test_enumerations();
  test_which_visitors_are_refused();
  test_bare_point();
  test_smallest_elements();
  test_examination();
  test_contains();
  for(const unsigned seed : { 1u, 2u, 3u })
    for(const int n : { 5, 40, 1000 })
    {
      test_simplex_index<1>(seed, n);
      test_simplex_index<2>(seed, n);
      test_simplex_index<3>(seed, n);
    }
  test_permutations<1>();
  test_permutations<2>();
  test_permutations<3>();
  test_colliding_hash_values();
  test_bits();
  test_bit_matrix();
  test_cell_spans();
  test_any_visitors();
  test_recording_visitor();
  test_phases();
  test_cancelling();
  test_short_steps();
  test_long_steps();
  test_finishing();
  test_running_time();
  std::cout << "done" << std::endl;
}
