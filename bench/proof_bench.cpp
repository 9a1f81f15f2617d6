// Ten million rays through random bodies whose surfaces coincide, each against an exact oracle:
// boxes and half-spaces on small integers in rational arithmetic, and bodies of every kind of leaf
// under maps that round against textbook formulas in 113-bit arithmetic.

#include "geometry/curved_models.h"
#include "report.h"

namespace {

using namespace lapidary;
using namespace lapidary::test::csg;

struct Tally {
  std::uint64_t rays = 0, wrong = 0, wrong_first = 0, undecided = 0;

  void count(Verdict verdict) {
    ++rays;
    if (verdict != Verdict::right) ++wrong;
    if (verdict == Verdict::wrong_first) ++wrong_first;
  }
};

Tally integers(std::uint64_t rays) {
  RandomModels random(2);
  Tally tally;
  while (tally.rays < rays) {
    const IntModel model = random.model(random.uniform(1, 8) / 2);
    const SolidScene scene = scene_of(model);
    for (int j = 0; j < 100; ++j) {
      const IntRay ray = random.ray();
      const auto exact = model.transitions(ray);
      Truth truth;
      truth.at_start = model.inside(ray, just_behind_start());
      for (const Rational t : exact) truth.t.push_back(t.value());
      tally.count(judge(scene, ray_of(ray), truth, 1e-6));
    }
  }
  return tally;
}

struct Setting {
  Transform world_from_model;
  double distinct = 1e-6;            ///< crossings closer than this are left to chance
  bool may_start_on_surface = true;  ///< far away, rounding puts the start on either side
};

void curved(const Setting& setting, std::uint64_t seed, std::uint64_t rays, Tally& tally) {
  CurvedModels models(seed);
  const std::uint64_t end = tally.rays + rays;
  while (tally.rays < end) {
    const CurvedModel model = models.model(1 + static_cast<int>(models.random().index(4)));
    const SolidScene scene = body(model.placed(setting.world_from_model), model.root);
    CurvedOracle oracle(model, setting.distinct);
    for (int j = 0; j < 50; ++j) {
      const geometry::Ray ray = models.ray();
      const auto truth = oracle.truth(ray);
      if (!truth || (truth->starts_on_surface && !setting.may_start_on_surface)) {
        ++tally.undecided;
      } else {
        tally.count(judge(scene, moved(setting.world_from_model, ray), *truth, setting.distinct));
      }
    }
  }
}

}  // namespace

int main() {
  constexpr std::uint64_t all = 10'000'000, curved_share = 500'000;
  const Setting settings[]{{Transform()},
                           {odd_placement()},
                           {odd_turn(1e-9, {})},
                           {odd_turn(1e9, {1e9, 0, -1e9})},
                           {odd_turn(1, {1e6, -1e6, 1e6}), 1e-4, false}};
  Tally of_curved;
  std::uint64_t seed = 3;
  for (const Setting& setting : settings) {
    curved(setting, seed++, curved_share / std::size(settings), of_curved);
  }
  const Tally of_integers = integers(all - of_curved.rays);
  const auto share = static_cast<double>(of_curved.undecided) /
                     static_cast<double>(of_curved.undecided + of_curved.rays);
  bench::report("proof.rays", static_cast<double>(of_integers.rays + of_curved.rays), "rays",
                ">=1e7");
  bench::report("proof.curved_rays", static_cast<double>(of_curved.rays), "rays");
  bench::report("proof.undecided_share", share, "1", "<=0.2");
  bench::report("proof.wrong_first_hits",
                static_cast<double>(of_integers.wrong_first + of_curved.wrong_first), "rays",
                "<=0");
  bench::report("proof.wrong_transitions", static_cast<double>(of_integers.wrong + of_curved.wrong),
                "rays", "<=0");
}
