#include <algorithm>

#include "light/light_tree.h"

namespace lapidary::light {
namespace {

constexpr double below_one = 1.0 - 0x1p-53;
/// Share of all weights.
constexpr double worth_dividing = 1.0 / 8;

}  // namespace

LightTree::Cut::Cut(const LightTree& tree, const LitPoint& to) : tree_(tree), to_(to) {
  if (tree.empty()) return;
  branches_[count_++] = {&tree.nodes_.front(), tree.nodes_.front().at(to), 0, 0};
  for (std::size_t before = 0; before != count_;) {
    before = count_;
    double sum = 0.0;
    for (const Branch& branch : std::span(branches_).first(before)) sum += branch.weight;
    for (Branch& branch : std::span(branches_).first(before)) {
      const bool is_large = branch.node->next != 0 && branch.weight > worth_dividing * sum;
      if (is_large && count_ < most) divide(branch);
    }
  }
  for (const Branch& branch : std::span(branches_).first(count_)) sum_ += branch.weight;
}

/// Into its two children.
void LightTree::Cut::divide(Branch& branch) {
  const Branch parent = branch;
  const Node *left = &tree_.nodes_[parent.node->next], *right = left + 1;
  const std::uint64_t turn = std::uint64_t{1} << parent.depth;
  branch = {left, left->at(to_), parent.depth + 1, parent.turns};
  branches_[count_++] = {right, right->at(to_), parent.depth + 1, parent.turns | turn};
}

Choice LightTree::Cut::choose(double u) const {
  if (!(sum_ > 0.0)) return {};
  double rest = u * sum_;
  const Branch* taken = nullptr;
  for (const Branch& branch : std::span(branches_).first(count_)) {
    if (branch.weight == 0.0) continue;
    taken = &branch;
    if (rest < branch.weight) break;
    rest -= branch.weight;
  }
  u = std::min(rest / taken->weight, below_one);
  double probability = taken->weight / sum_;
  const Node* node = taken->node;
  while (node->next != 0) {
    const auto [left, right] = tree_.shares(*node, to_);
    if (left + right == 0.0) return {};
    const bool goes_left = u < left;
    const double share = goes_left ? left : right;
    u = std::clamp(goes_left ? u / share : (u - left) / share, 0.0, below_one);
    probability *= share;
    node = &tree_.nodes_[node->next + (goes_left ? 0 : 1)];
  }
  return {node->light, probability, u};
}

double LightTree::Cut::probability(std::size_t index) const {
  const std::uint64_t trail = tree_.trails_[index];
  if (trail == 0 || !(sum_ > 0.0)) return 0.0;
  const auto holds_light = [trail](const Branch& branch) {
    const std::uint64_t before = (std::uint64_t{1} << branch.depth) - 1;
    return (trail & before) == branch.turns && trail > before;
  };
  const auto branches = std::span(branches_).first(count_);
  const Branch& branch = *std::ranges::find_if(branches, holds_light);
  const Node* node = branch.node;
  double probability = branch.weight / sum_;
  for (std::uint64_t turns = trail >> branch.depth; turns != 1 && probability > 0.0; turns >>= 1) {
    const auto [left, right] = tree_.shares(*node, to_);
    const bool goes_left = (turns & 1) == 0;
    probability *= goes_left ? left : right;
    node = &tree_.nodes_[node->next + (goes_left ? 0 : 1)];
  }
  return probability;
}

}  // namespace lapidary::light
