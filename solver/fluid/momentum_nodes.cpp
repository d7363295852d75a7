#include "solver/fluid/momentum_nodes.hpp"

#include <cmath>
#include <utility>

namespace slfb::fluid {

MomentumNodes::MomentumNodes(const ColumnGrid& of, std::size_t along, LateralBoundary wall, bool is_closed)
    : grid(of), axis(along), closed(is_closed) {
  build_links();
  std::vector<double> volumes(grid.size());
  for (int cell = 0; cell < grid.cells(); ++cell)
    for (int k = 0; k < grid.layers(); ++k) volumes[index_of(cell, k, grid.layers())] = grid.volume(cell);
  volume.assign(size(), 0.0);
  scatter({0, sections}, volumes, volume);
  build_stencil(wall);
}

/// Neighbours of each section node, the cells beside it and its shares in them.
void MomentumNodes::build_links() {
  const int layers = grid.layers();
  const auto across = [&](int cell, std::size_t direction, std::size_t side) {
    const int face = grid.face_of(cell, direction, side);
    if (face < 0) return -1;
    const auto& f = grid.faces(direction)[as_index(face)];
    return side == 0 ? f.first : f.second;
  };
  sections = axis == vertical ? grid.cells() : static_cast<int>(grid.faces(axis).size());
  levels = axis == vertical ? layers + 1 : layers;
  first = axis == vertical ? 1 : 0;
  last = axis == vertical && closed ? layers - 1 : levels - 1;
  for (int s = 0; s < sections; ++s) {
    std::array<int, 4> next{-1, -1, -1, -1};
    if (axis == vertical) {
      for (std::size_t direction : {std::size_t{0}, std::size_t{1}})
        for (std::size_t side : {std::size_t{0}, std::size_t{1}})
          next[2 * direction + side] = across(s, direction, side);
      owner.push_back({s, s});
      share.push_back({0.5, 0.5});
    } else {
      const auto& face = grid.faces(axis)[as_index(s)];
      const std::size_t cross = 1 - axis;
      next[2 * axis] = grid.face_of(face.first, axis, 0);
      next[2 * axis + 1] = grid.face_of(face.second, axis, 1);
      for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const int cell = across(face.first, cross, side), second = across(face.second, cross, side);
        if (cell < 0 || second < 0) continue;
        const int candidate = grid.face_of(cell, axis, 1);
        if (candidate >= 0 && grid.faces(axis)[as_index(candidate)].second == second)
          next[2 * cross + side] = candidate;
      }
      owner.push_back({face.first, face.second});
      share.push_back(
          {grid.face_of(face.first, axis, 0) >= 0 ? 0.5 : 1.0, grid.face_of(face.second, axis, 1) >= 0 ? 0.5 : 1.0});
    }
    neighbour.push_back(next);
  }
}

/// Weights of ∇². Where the wall is nearer than the next node it takes its place at its own distance (Shortley and
/// Weller 1938); past the outlet and slip walls the velocity goes on unchanged.
///
/// The differences are taken at the lattice points, while a node's velocity is the mean over its face, which the round
/// wall may cut off centre. In between stands the part of the velocity that is left at the lattice point: the ratio of
/// R² − r² there and at the centroid, as next to any wall without slip.
void MomentumNodes::build_stencil(LateralBoundary wall) {
  for (auto* weights : {&lateral, &mirror})
    for (auto& weight : *weights) weight.assign(as_index(sections), 0.0);
  own.assign(as_index(sections), 0.0);
  const double radius = grid.radius();
  const auto lattice_point = [&](int s) {
    auto point = grid.centre(owner[as_index(s)][0]);
    if (axis != vertical) point[axis] += 0.5 * grid.spacing(axis);
    return point;
  };
  const auto part_at_lattice_point = [&](int s) {
    if (radius == 0.0 || wall != LateralBoundary::no_slip || grid.cells() == 1) return 1.0;
    const auto point = lattice_point(s);
    const auto mean = position(index_of(s, 0, levels));
    return (radius * radius - point[0] * point[0] - point[1] * point[1]) /
           (radius * radius - mean[0] * mean[0] - mean[1] * mean[1]);
  };
  for (int s = 0; s < sections; ++s) {
    const auto point = lattice_point(s);
    const double part = part_at_lattice_point(s);
    for (std::size_t direction : {std::size_t{0}, std::size_t{1}}) {
      const double width = grid.spacing(direction);
      std::array<double, 2> distance{width, width};
      std::array<bool, 2> at_wall{false, false};
      for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        if (neighbour[as_index(s)][2 * direction + side] >= 0) continue;
        mirror[2 * direction + side][as_index(s)] = 1.0;
        const double to_wall = grid.wall_distance(point, direction, side);
        // A slip wall holds back only what flows towards it; on the round wall neither direction is that direction.
        at_wall[side] =
            std::isfinite(to_wall) && (wall == LateralBoundary::no_slip ||
                                       (wall == LateralBoundary::slip && direction == axis && grid.radius() == 0.0));
        if (!at_wall[side]) continue;
        distance[side] = to_wall;  // not 0: every lattice point lies inside
        mirror[2 * direction + side][as_index(s)] = std::max(-1.0, 1.0 - width / distance[side]);
      }
      for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const double weight = 2.0 / (distance[side] * (distance[0] + distance[1]));
        const int next = neighbour[as_index(s)][2 * direction + side];
        if (at_wall[side] || next >= 0) own[as_index(s)] += weight * part;
        if (next >= 0) lateral[2 * direction + side][as_index(s)] = weight * part_at_lattice_point(next);
      }
    }
  }
  const double height = grid.cell_height();
  below.assign(as_index(levels), 1.0 / (height * height));
  above = below;
  if (axis == vertical) {
    if (!closed) {  // the outlet mirrors the velocity
      below.back() *= 2.0;
      above.back() = 0.0;
    }
    return;
  }
  // The end planes are half a cell away.
  const double near = 2.0 / (0.5 * height * 1.5 * height), far = 2.0 / (height * 1.5 * height);
  below.front() = near;
  above.front() = far;
  if (closed) {
    below.back() = far;
    above.back() = near;
  } else {
    above.back() = 0.0;
  }
}

std::array<double, 3> MomentumNodes::position(std::size_t node) const {
  const auto level = static_cast<double>(node % as_index(levels));
  const std::size_t section = node / as_index(levels);
  const double height = grid.cell_height();
  const int cell = owner[section][0];
  if (axis == vertical) return {grid.centroid(cell)[0], grid.centroid(cell)[1], level * height};
  std::array<double, 3> result{0.0, 0.0, (level + 0.5) * height};
  result[axis] = grid.centre(cell)[axis] + 0.5 * grid.spacing(axis);
  result[1 - axis] = grid.faces(axis)[section].middle;
  return result;
}

double MomentumNodes::face_area(int section) const {
  return axis == vertical ? grid.area(section) : grid.faces(axis)[as_index(section)].length * grid.cell_height();
}

double MomentumNodes::spacing(int level) const {
  if (axis != vertical) return grid.spacing(axis);
  return level == grid.layers() ? 0.5 * grid.cell_height() : grid.cell_height();
}

void MomentumNodes::scatter(SectionRange range, const std::vector<double>& cells, std::vector<double>& nodes) const {
  const auto layers = as_index(grid.layers());
  for (int s = range.first; s < range.last; ++s) {
    const auto& cell = owner[as_index(s)];
    const auto& part = share[as_index(s)];
    const double *lower = &cells[index_of(cell[0], 0, grid.layers())],
                 *upper = &cells[index_of(cell[1], 0, grid.layers())];
    double* node = &nodes[index_of(s, 0, levels)];
    if (axis == vertical) {
      for (std::size_t k = 1; k < layers; ++k) node[k] = 0.5 * lower[k - 1] + 0.5 * lower[k];
      // The lowest cell's share of the inlet face goes to the first free node above it; likewise below a closed top.
      node[0] = 0.0;
      node[layers] = 0.5 * lower[layers - 1];
      node[1] += 0.5 * lower[0];
      if (closed) node[layers - 1] += std::exchange(node[layers], 0.0);
    } else {
      for (std::size_t k = 0; k < layers; ++k) node[k] = part[0] * lower[k] + part[1] * upper[k];
    }
  }
}

}  // namespace slfb::fluid
