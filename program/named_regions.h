#ifndef BOUNDARY_RECOVERY_3_PROGRAM_NAMED_REGIONS_H
#define BOUNDARY_RECOVERY_3_PROGRAM_NAMED_REGIONS_H

#include "surface.h"

#include <CGAL/Boundary_recovery_3/internal/mesh/regions_at_places.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

// The names of regions, by places in them.
class Named_regions
{
  std::map<int, std::string> m_names;
  std::string m_message;

public:
  // looks up the regions in a triangulation that is marked; `message()` says if a place is in none, or if a region gets
  // two names
  template <typename Triangulation>
  void find(const Triangulation& tr, const std::vector<Named_place<typename Triangulation::Point> >& places)
  {
    for(const auto& [name, place] : places)
    {
      const int region = CGAL::Boundary_recovery_3::internal::region_at(tr, place).value_or(0);
      const auto inserted = m_names.emplace(region, name);
      if(region == 0)
        set_message(name, place, "is in no region: it is outside, on the surface, or in a void");
      else if(inserted.first->second != name)
        set_message(name, place, "is in a region that has the name " + inserted.first->second);
    }
    m_names.erase(0);
  }

  const std::map<int, std::string>& names() const { return m_names; }
  const std::string& message() const { return m_message; }

private:
  template <typename Point>
  void set_message(const std::string& name, const Point& place, const std::string& what)
  {
    std::ostringstream os;
    os << "the place (" << place << ") of " << name << ' ' << what;
    if(m_message.empty())
      m_message = os.str();
  }
};

#endif // BOUNDARY_RECOVERY_3_PROGRAM_NAMED_REGIONS_H
