#include "description/node_readers.h"

namespace lapidary::description {
namespace {

void collect(const schema::Value& value, const schema::Context& context,
             std::vector<ObjectPtr>& objects) {
  if (value.kind() == schema::ValueKind::table && value.table().fields.empty()) {
    const auto items = value.table().items;
    for (std::size_t i = 0; i < items.size(); ++i) collect(items[i], context.at(i), objects);
    return;
  }
  objects.push_back(schema::Reader<ObjectPtr>::read(value, context));
}

}  // namespace

std::vector<ObjectPtr> ObjectListReader::read(const schema::Value& value,
                                              const schema::Context& context) {
  std::vector<ObjectPtr> objects;
  collect(value, context, objects);
  return objects;
}

}  // namespace lapidary::description
