#include <setae/interactions/section_beam.h>
#include <setae/laws/disk_cylinder.h>
#include <setae/laws/lennard_jones.h>

#include "../nested_sacado.h"
#include "cell_pair.h"

using namespace Setae;

namespace
{
  constexpr SectionPair sections = {.02, .03, 1., 1.};
  constexpr double sum_of_radii = .05;
  DiskCylinder law(const GapRange &range)
  {
    return DiskCylinder(lennard_jones_of_cylinders(1e-3, -1., sections), sections, range);
  }
  LocalSystem<24> by_hand(const SectionBeam<DiskCylinder> &interaction, const CellPair &cells, double x, const FiberEnds &ends)
  {
    LocalSystem<24> local;
    interaction.add(site_at(cells.source, x), cells.target, ends, 1.7, Request::tangent, local);
    local.symmetrize();
    return local;
  }
  LocalSystem<24> by_sacado(const SectionBeam<DiskCylinder> &interaction, const CellPair &cells, double x, const FiberEnds &ends)
  {
    const auto q = variables<24>(cells.coefficients());
    const auto source = cell_of(q, 0, cells.source.h), target = cell_of(q, 12, cells.target.h);
    NestedFad<24> energy(0.);
    for (const Projection &projection : closest_points(cells.target, cells.source.position(x), ends))
      energy += NestedFad<24>(1.7 * interaction.energy(source.position(x), source.derivative(x), target, projection));
    return local_system<24>(energy);
  }
}

TEST(SectionBeam, X)
{
  std::mt19937 random(1);
  SectionBeam<DiskCylinder> interaction(law({}), sum_of_radii);
  for (unsigned int i=0;i<50;++i)
  {
    HermiteCell<> target = random_cell(random_vector(random), .5, .5, random);
    const double xi = .7, x = .2;
    HermiteCell<> source = random_cell(random_vector(random), .3, .5, random);
    const double gap = 2e-3;
    move_to(source, x, target.position(xi) + (gap+sum_of_radii)*random_normal_to(target.derivative(xi),random));
    const CellPair cells{source,target};
    auto a=by_hand(interaction,cells,x,{}), b=by_sacado(interaction,cells,x,{});
    auto d = deviation(a,b);
    std::cout << closest_points(target,source.position(x),{}).size() << " " << b.energy << " " << d.energy << ' ' << d.residual << ' ' << d.tangent << std::endl;
  }
}
