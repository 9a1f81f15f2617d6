#include "description/combination.h"

#include <cassert>
#include <utility>

#include "description/object.h"

namespace lapidary::description {
namespace {

/// Whether `object` surely holds no version of `list`. Looks at a few parts only: who appends a
/// large combination may as well nest it.
bool is_free_of(const Object& object, const void* list) {
  if (parts_of(object).objects.empty()) return true;
  constexpr std::size_t patience = 32;
  std::vector<const Object*> pending{&object};
  for (std::size_t i = 0; i < pending.size(); ++i) {
    const auto* combination = std::get_if<Combination>(&pending[i]->content);
    if (combination && combination->list() == list) return false;
    const auto parts = parts_of(*pending[i]).objects;
    if (pending.size() + parts.size() > patience) return false;
    for (const ObjectPtr& part : parts) pending.push_back(part.get());
  }
  return true;
}

}  // namespace

Combination::Combination(SetOperation operation, std::vector<ObjectPtr> operands)
    : list_(std::make_shared<List>()),
      size_(static_cast<std::uint32_t>(operands.size())),
      operation_(operation) {
  assert(operation != SetOperation::complement || size_ == 1);
  assert(operation == SetOperation::unite || size_ >= 1);
  list_->operands = std::move(operands);
}

Combination::List::~List() {
  release(std::move(operands));
}

std::optional<Combination> Combination::appended(const ObjectPtr& operand) const {
  assert(operation_ != SetOperation::complement);
  if (list_->operands.size() != size_ || !is_free_of(*operand, list_.get())) return std::nullopt;
  list_->operands.push_back(operand);
  Combination longer = *this;
  ++longer.size_;
  return longer;
}

void release(std::vector<ObjectPtr>&& objects) noexcept {
  // The outermost call frees for all those that its freeing leads to.
  thread_local std::vector<std::vector<ObjectPtr>>* pending = nullptr;
  if (objects.empty()) return;
  if (pending) return pending->push_back(std::move(objects));
  std::vector<std::vector<ObjectPtr>> mine;
  pending = &mine;
  mine.push_back(std::move(objects));
  while (!mine.empty()) {
    const std::vector<ObjectPtr> next = std::move(mine.back());
    mine.pop_back();
  }
  pending = nullptr;
}

}  // namespace lapidary::description
