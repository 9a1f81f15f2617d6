#include "distributed/worker.h"

#include <utility>

#include "distributed/byte_stream.h"

namespace lapidary::distributed {
namespace {

class Worker {
 public:
  Worker(Orders& orders, const Equipment& equipment)
      : orders_(orders), pixels_(equipment.settings.pixels()), thread_(equipment) {}

  void work() {
    while (!orders_.are_over()) {
      bool is_news = false;
      while (const auto order = orders_.poll()) {
        carry_out(*order);
        is_news = true;
      }
      if (!deliver() && !is_news) nap(orders_.channel());
    }
  }

 private:
  void carry_out(const Message& order) {
    switch (order.topic) {
      case Topic::run:
        return thread_.add(read_pass_message(*order.bytes));
      case Topic::drop:
        return thread_.drop(read_pass_message(*order.bytes));
      case Topic::epoch:
        return thread_.learn(read_epoch_message(*order.bytes, pixels_));
      case Topic::finish:
        thread_.finish();
        is_finishing_ = true;
        return;
      default:
        ByteReader::fail();
    }
  }

  /// Whether there was anything.
  bool deliver() {
    bool is_news = false;
    while (const auto rendered = thread_.take()) {
      orders_.channel().send(0, film_message(*rendered));
      is_news = true;
    }
    if (is_finishing_ && thread_.is_idle()) {
      orders_.channel().send(0, {Topic::idle});
      is_finishing_ = false;
    }
    return is_news;
  }

  Orders& orders_;
  std::size_t pixels_;
  RunThread thread_;
  bool is_finishing_ = false;
};

}  // namespace

void work(Orders& orders, const Equipment& equipment) {
  Worker(orders, equipment).work();
  orders.take_leave();
}

void fail(Orders& orders, std::string_view why) {
  ByteWriter writer;
  writer.add(why);
  orders.channel().send(0, std::move(writer).message(Topic::failed));
  while (!orders.are_over()) {
    if (!orders.poll()) nap(orders.channel());
  }
  orders.take_leave();
}

}  // namespace lapidary::distributed
