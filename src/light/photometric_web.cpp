#include "light/photometric_web.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "math/constants.h"

namespace lapidary::light {
namespace {

/// For each angle of a whole circle, wherever that begins, the plane of the table that it is like.
std::map<double, std::size_t> whole_circle(const std::vector<double>& stated) {
  std::map<double, std::size_t> planes;
  if (stated.size() == 1) return {{0.0, 0}, {360.0, 0}};
  const double first = stated.front(), last = stated.back();
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const double angle = stated[i];
    planes.emplace(angle, i);
    if (last == 90.0) {
      planes.emplace(180.0 - angle, i);
      planes.emplace(180.0 + angle, i);
      planes.emplace(360.0 - angle, i);
    } else if (last == 180.0) {
      planes.emplace(360.0 - angle, i);
    } else if (first == 90.0) {
      planes.emplace(540.0 - angle, i);
    }
  }
  return planes;
}

/// Of type A or B: with what is below zero, where that is left out.
std::vector<double> both_sides(const std::vector<double>& stated) {
  std::vector<double> angles;
  if (stated.front() == 0.0) {
    for (std::size_t i = stated.size() - 1; i > 0; --i) angles.push_back(-stated[i]);
  }
  angles.insert(angles.end(), stated.begin(), stated.end());
  return angles;
}

/// The number of the stated angle that one of both sides is like.
std::size_t stated_of(std::size_t i, std::size_t stated, std::size_t both) {
  const std::size_t mirrored = both - stated;
  return i < mirrored ? mirrored - i : i - mirrored;
}

std::size_t cell_of(const std::vector<double>& edges, double x) {
  const auto above = std::upper_bound(edges.begin(), edges.end(), x);
  const auto index = std::max<std::ptrdiff_t>(above - edges.begin() - 1, 0);
  return std::min(static_cast<std::size_t>(index), edges.size() - 2);
}

}  // namespace

// Types A and B by latitude, which is 90 degrees minus the polar angle, and longitude about their
// polar axis. Of type A the longitude is the horizontal angle, of type B the vertical one.
PhotometricWeb::Grid PhotometricWeb::grid_of(const Table& table) {
  Grid grid;
  const std::size_t verticals = table.vertical.size(), horizontals = table.horizontal.size();
  if (table.type == Type::c) {
    grid.polar = table.vertical;
    for (const auto& [angle, plane] : whole_circle(table.horizontal)) {
      grid.azimuth.push_back(angle);
      const auto begin = table.candela.begin() + static_cast<std::ptrdiff_t>(plane * verticals);
      grid.candela.insert(grid.candela.end(), begin,
                          begin + static_cast<std::ptrdiff_t>(verticals));
    }
    return grid;
  }
  const std::vector<double> vertical = both_sides(table.vertical);
  const std::vector<double> horizontal = both_sides(table.horizontal);
  const bool by_horizontal = table.type == Type::a;
  grid.azimuth = by_horizontal ? horizontal : vertical;
  const std::vector<double>& latitude = by_horizontal ? vertical : horizontal;
  for (std::size_t i = latitude.size(); i-- > 0;) grid.polar.push_back(90.0 - latitude[i]);
  for (std::size_t longitude = 0; longitude < grid.azimuth.size(); ++longitude) {
    for (std::size_t i = latitude.size(); i-- > 0;) {
      const std::size_t v = stated_of(by_horizontal ? i : longitude, verticals, vertical.size());
      const std::size_t h =
          stated_of(by_horizontal ? longitude : i, horizontals, horizontal.size());
      grid.candela.push_back(table.candela[h * verticals + v]);
    }
  }
  return grid;
}

// The web's z is the polar axis; azimuths grow from its x, where both angles are 0, towards its -y.
Vec3d PhotometricWeb::web_from_lamp(Vec3d v) const {
  if (type_ == Type::c) return v;
  return type_ == Type::a ? Vec3d(v.z, -v.y, v.x) : Vec3d(v.z, -v.x, v.y);
}

Vec3d PhotometricWeb::lamp_from_web(Vec3d v) const {
  if (type_ == Type::c) return v;
  return type_ == Type::a ? Vec3d(v.z, -v.y, v.x) : Vec3d(-v.y, v.z, v.x);
}

PhotometricWeb::PhotometricWeb(const Table& table) : type_(table.type) {
  Grid grid = grid_of(table);
  for (const double angle : grid.polar) vertical_.push_back(radians(angle));
  for (const double angle : grid.azimuth) horizontal_.push_back(radians(angle));
  candela_ = std::move(grid.candela);
  std::vector<double> by_column;
  for (std::size_t column = 0; column + 1 < horizontal_.size(); ++column) {
    std::vector<double> by_row;
    for (std::size_t row = 0; row + 1 < vertical_.size(); ++row) {
      by_row.push_back(flux_of_cell(column, row));
    }
    rows_.emplace_back(by_row);
    by_column.push_back(rows_.back().total());
  }
  columns_.emplace(by_column);
  flux_ = columns_->total();
}

// The intensity is linear in the horizontal angle, so that its mean is that of the two sides; of
// what is linear in the vertical angle, times its sine, the integral is a closed form.
double PhotometricWeb::flux_of_cell(std::size_t column, std::size_t row) const {
  const double a = vertical_[row], b = vertical_[row + 1];
  const double top = 0.5 * (at_corner(column, row) + at_corner(column + 1, row));
  const double bottom = 0.5 * (at_corner(column, row + 1) + at_corner(column + 1, row + 1));
  const double of_one = std::cos(a) - std::cos(b);
  const double of_rise = (std::sin(b) - std::sin(a)) / (b - a) - std::cos(b);
  const double width = horizontal_[column + 1] - horizontal_[column];
  return width * std::max(top * (of_one - of_rise) + bottom * of_rise, 0.0);
}

double PhotometricWeb::solid_angle(std::size_t column, std::size_t row) const {
  const double width = horizontal_[column + 1] - horizontal_[column];
  return width * (std::cos(vertical_[row]) - std::cos(vertical_[row + 1]));
}

std::optional<PhotometricWeb::Place> PhotometricWeb::place_of(Vec3d of_lamp) const {
  const Vec3d direction = web_from_lamp(of_lamp);
  const double vertical = std::atan2(std::hypot(direction.x, direction.y), direction.z);
  // What is measured up to 90 degrees lights the horizon, too, however that is rounded.
  constexpr double slack = 1e-9;
  if (vertical < vertical_.front() - slack || vertical > vertical_.back() + slack) return {};
  double horizontal = std::atan2(-direction.y, direction.x);
  if (horizontal < horizontal_.front() - slack) horizontal += 2.0 * pi;
  if (horizontal > horizontal_.back() + slack) return {};
  Place place{cell_of(horizontal_, horizontal), cell_of(vertical_, vertical)};
  const auto within = [](const std::vector<double>& edges, std::size_t cell, double x) {
    return std::clamp((x - edges[cell]) / (edges[cell + 1] - edges[cell]), 0.0, 1.0);
  };
  place.across = within(horizontal_, place.column, horizontal);
  place.down = within(vertical_, place.row, vertical);
  return place;
}

double PhotometricWeb::intensity(Vec3d direction) const {
  const auto place = place_of(direction);
  if (!place) return 0.0;
  const auto [column, row, s, t] = *place;
  const double top = at_corner(column, row) * (1.0 - s) + at_corner(column + 1, row) * s;
  const double bottom = at_corner(column, row + 1) * (1.0 - s) + at_corner(column + 1, row + 1) * s;
  return top * (1.0 - t) + bottom * t;
}

// In a cell the cosine to any axis of the web is least at a corner.
double PhotometricWeb::least_cosine() const {
  double least = 1.0;
  for (std::size_t column = 0; column + 1 < horizontal_.size(); ++column) {
    for (std::size_t row = 0; row + 1 < vertical_.size(); ++row) {
      if (!(flux_of_cell(column, row) > 0.0)) continue;
      for (const std::size_t c : {column, column + 1}) {
        for (const std::size_t r : {row, row + 1}) {
          const double sine = std::sin(vertical_[r]);
          const Vec3d corner(sine * std::cos(horizontal_[c]), -sine * std::sin(horizontal_[c]),
                             std::cos(vertical_[r]));
          least = std::min(least, lamp_from_web(corner).z);
        }
      }
    }
  }
  return least;
}

PhotometricWeb::Sample PhotometricWeb::sample(Vec2d u) const {
  const auto column = columns_->sample(u.x);
  const auto row = rows_[column.index].sample(u.y);
  const double left = horizontal_[column.index], right = horizontal_[column.index + 1];
  const double phi = left + column.remainder * (right - left);
  const double top = std::cos(vertical_[row.index]), bottom = std::cos(vertical_[row.index + 1]);
  const double z = top + row.remainder * (bottom - top);
  const double sine = std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z)));
  const double pdf = column.probability * row.probability / solid_angle(column.index, row.index);
  return {lamp_from_web({sine * std::cos(phi), -sine * std::sin(phi), z}), pdf};
}

double PhotometricWeb::pdf(Vec3d direction) const {
  const auto place = place_of(direction);
  if (!place) return 0.0;
  return columns_->probability(place->column) * rows_[place->column].probability(place->row) /
         solid_angle(place->column, place->row);
}

}  // namespace lapidary::light
