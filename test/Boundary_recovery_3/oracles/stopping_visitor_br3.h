// A visitor that counts the questions whether to go further, and says no to one of them.

#ifndef BR3_TEST_STOPPING_VISITOR_H
#define BR3_TEST_STOPPING_VISITOR_H

#include <CGAL/Boundary_recovery_3/Boundary_recovery_visitor_3.h>

#include <cstddef>

namespace br3_test {

struct Stopping_visitor
  : public CGAL::Default_boundary_recovery_visitor_3
{
  bool go_further() { return number_of_questions++ != last_question; }

  std::size_t number_of_questions = 0;
  std::size_t last_question = std::size_t(-1);
};

} // namespace br3_test

#endif // BR3_TEST_STOPPING_VISITOR_H
