// Those who say no when they are asked whether to go further.

#ifndef BR3_TEST_STOPPING_VISITOR_H
#define BR3_TEST_STOPPING_VISITOR_H

#include <CGAL/Boundary_recovery_3/internal/util/Mesh_visitor_3.h>

#include <cstddef>

namespace br3_test {

// Counts the questions, and says no to one of them.
template <typename Tr>
struct Stopping_visitor
  : public CGAL::Boundary_recovery_3::internal::Mesh_visitor_3<Tr>
{
  bool go_further() override { return number_of_questions++ != last_question; }

  std::size_t number_of_questions = 0;
  std::size_t last_question = std::size_t(-1);
};

// A context that says no after so many steps.
struct Patience
{
  int number_of_steps;
  bool go_further() { return number_of_steps-- > 0; }
};

} // namespace br3_test

#endif // BR3_TEST_STOPPING_VISITOR_H
