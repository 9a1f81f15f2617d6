#include <algorithm>

#include "geometry/lathe.h"
#include "geometry/lathe_data.h"
#include "geometry/lathe_profile.h"
#include "geometry/stretch.h"

namespace lapidary::geometry {
namespace {

using Data = Lathe::Data;

constexpr double u_ = rounding_unit;

/// The stretches of the line inside of the whole turn, from one entry to the next exit.
class Chords {
 public:
  Chords(const Data& data, const ProfileLine& line) : profile_(data, line), line_(line) {
    profile_.find(found_);
    std::sort(found_.begin(), found_.end(), [](const ProfileCrossing& a, const ProfileCrossing& b) {
      return a.s != b.s ? a.s < b.s : a.edge < b.edge;
    });
  }

  bool next(Stretch& chord) {
    const ProfileCrossing* entry = step(Crossing::enter);
    const ProfileCrossing* exit = step(Crossing::leave);
    if (entry == nullptr || exit == nullptr) return false;
    chord = {line_.line.m + entry->s, line_.line.m + exit->s};
    chord.enter_error = profile_.tau(*entry) + u_ * std::abs(chord.enter);
    chord.leave_error = profile_.tau(*exit) + u_ * std::abs(chord.leave);
    chord.enter_patch = Data::first_edge + entry->edge;
    chord.leave_patch = Data::first_edge + exit->edge;
    return true;
  }

 private:
  /// The next crossing at which there come to be more entries than exits, or no more so.
  const ProfileCrossing* step(Crossing crossing) {
    while (position_ < found_.size()) {
      const ProfileCrossing& found = found_[position_++];
      const bool was_inside = surplus_ > 0;
      surplus_ += found.enters ? 1 : -1;
      const bool is_inside = surplus_ > 0;
      if (is_inside != was_inside && is_inside == (crossing == Crossing::enter)) return &found;
    }
    return nullptr;
  }

  LatheProfile profile_;
  const ProfileLine& line_;
  ProfileCrossings found_;
  std::size_t position_ = 0;
  int surplus_ = 0;
};

/// The part of the line below a plane through the axis, as a cap.
Stretch below(Vec3d normal, const Line& line, Patch cap) {
  const Plane plane{{}, normal};
  const Bounded height = height_over(plane, line), slope = slope_over(plane, line);
  if (is_parallel(slope)) return is_below(height, normal) ? Stretch{} : Stretch::nowhere();
  const PlaneCrossing at = cross_plane(height, slope, 1.0 / slope.value);
  if (slope.value > 0.0) return {-infinity, at.t, 0, at.tau, cap, cap};
  return {at.t, infinity, at.tau, 0, cap, cap};
}

/// What a part of a turn leaves of the chords of the whole.
class Sector {
 public:
  Sector(const Data& data, const Line& line) : is_reflex_(data.is_reflex()) {
    // A turn by more than 180 degrees is all but the wedge that is missing.
    const double side = is_reflex_ ? -1.0 : 1.0;
    wedge_ = intersect(below(data.start_normal() * side, line, Data::start_cap),
                       below(data.end_normal() * side, line, Data::end_cap));
    if (data.degrees != 180.0) return;
    // Both caps are in one plane.
    const auto cap_at = [&](double t) {
      return line.at(t).x < 0.0 ? Data::end_cap : Data::start_cap;
    };
    wedge_.enter_patch = cap_at(wedge_.enter), wedge_.leave_patch = cap_at(wedge_.leave);
  }

  template <typename Push>
  void cut(const Stretch& chord, const Push& push) const {
    if (!is_reflex_) return push(intersect_if_any(chord, wedge_));
    if (wedge_.empty()) return push(chord);
    const Stretch before{-infinity, wedge_.enter, 0, wedge_.enter_error, 0, wedge_.enter_patch};
    const Stretch after{wedge_.leave, infinity, wedge_.leave_error, 0, wedge_.leave_patch, 0};
    push(intersect_if_any(chord, before));
    push(intersect_if_any(chord, after));
  }

 private:
  static Stretch intersect_if_any(const Stretch& a, const Stretch& b) {
    const bool is_any = std::max(a.enter, b.enter) < std::min(a.leave, b.leave);
    return is_any ? intersect(a, b) : Stretch::nowhere();
  }

  bool is_reflex_;
  Stretch wedge_;
};

/// Chords that touch, once rounded, are one.
void push_chord(const Stretch& chord, EventBuffer& events) {
  if (chord.empty()) return;
  if (!events.empty() && !(events[events.size() - 1].t < chord.enter)) {
    events.drop_last();
  } else {
    events.push({chord.enter, chord.enter_error, chord.enter_patch, Crossing::enter});
  }
  events.push({chord.leave, chord.leave_error, chord.leave_patch, Crossing::leave});
}

}  // namespace

void intervals(const Lathe& lathe, const Line& line, EventBuffer& events) {
  events.clear();
  const Data& data = *lathe.data_;
  const ProfileLine profile = profile_line(line, data.base, data.radius);
  if (profile.misses()) return;
  Chords chords(data, profile);
  Stretch chord;
  if (data.is_whole()) {
    while (chords.next(chord)) push_chord(chord, events);
    return;
  }
  const Sector sector(data, line);
  while (chords.next(chord)) {
    sector.cut(chord, [&](const Stretch& part) { push_chord(part, events); });
  }
}

}  // namespace lapidary::geometry
