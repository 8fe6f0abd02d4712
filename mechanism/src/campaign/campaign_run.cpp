// Computes blocks of rows on threads, and passes them on in order.
#include <algorithm>
#include <assur/mechanism/campaign.hpp>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace assur::mechanism::campaign {

namespace {

/// Enough items to make the cost of passing on a block negligible beside its computation.
constexpr std::uint64_t items_of_a_block = 256;

using Encode = std::function<std::string(const std::vector<double>&)>;

/// The blocks of a range, by their numbers.
struct Blocks {
  ItemRange items;

  [[nodiscard]] std::uint64_t count() const {
    return (items.last - items.first + items_of_a_block - 1) / items_of_a_block;
  }
  [[nodiscard]] ItemRange range(std::uint64_t block) const {
    const std::uint64_t first = items.first + block * items_of_a_block;
    return {first, std::min(first + items_of_a_block, items.last)};
  }
};

void compute(const Campaign::Worker& worker, ItemRange items, const Encode& encode,
             RowBlock& block) {
  block.items = items;
  block.rows.clear();
  for (std::uint64_t item = items.first; item < items.last; ++item) {
    worker(item, block.rows);
  }
  if (encode) {
    block.text = encode(block.rows);
  }
}

/// Threads that compute blocks slightly ahead of the one that is passed on next.
class Pipeline {
 public:
  Pipeline(const Campaign& campaign, const Blocks& blocks, int threads, const Encode& encode)
      : campaign_(campaign),
        blocks_(blocks),
        encode_(encode),
        slots_(static_cast<std::size_t>(threads) * 4) {
    const auto useful =
        static_cast<int>(std::min(blocks.count(), static_cast<std::uint64_t>(threads)));
    try {
      for (int thread = 0; thread < useful; ++thread) {
        threads_.emplace_back([this] { work(); });
      }
    } catch (const std::system_error&) {  // fewer threads than requested are enough
      if (threads_.empty()) {
        throw;
      }
    }
  }
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;
  ~Pipeline() {
    {
      const std::scoped_lock lock(mutex_);
      next_ = blocks_.count();
    }
    room_.notify_all();
  }

  void hand_over(const std::function<void(const RowBlock&)>& use) {
    for (std::uint64_t number = 0; number < blocks_.count(); ++number) {
      Slot& slot = slot_of(number);
      {
        std::unique_lock lock(mutex_);
        done_.wait(lock, [&slot] { return slot.is_done; });
      }
      if (slot.error) {
        std::rethrow_exception(slot.error);
      }
      use(slot.block);
      {
        const std::scoped_lock lock(mutex_);
        slot.is_done = false;
        handed_over_ = number + 1;
      }
      room_.notify_one();
    }
  }

 private:
  struct Slot {
    RowBlock block;
    std::exception_ptr error;
    bool is_done = false;
  };

  [[nodiscard]] Slot& slot_of(std::uint64_t number) { return slots_[number % slots_.size()]; }

  void work() {
    std::exception_ptr error;
    Campaign::Worker worker;
    try {
      worker = campaign_.worker();
    } catch (...) {
      error = std::current_exception();
    }
    while (true) {
      std::uint64_t number = 0;
      {
        std::unique_lock lock(mutex_);
        room_.wait(lock, [this] {
          return next_ >= blocks_.count() || next_ < handed_over_ + slots_.size();
        });
        if (next_ >= blocks_.count()) {
          return;
        }
        number = next_++;
      }
      Slot& slot = slot_of(number);
      try {
        if (!error) {
          compute(worker, blocks_.range(number), encode_, slot.block);
        }
      } catch (...) {
        error = std::current_exception();
      }
      {
        const std::scoped_lock lock(mutex_);
        slot.error = error;
        slot.is_done = true;
      }
      done_.notify_one();
    }
  }

  const Campaign& campaign_;
  Blocks blocks_;
  const Encode& encode_;
  std::mutex mutex_;
  std::condition_variable room_, done_;
  std::vector<Slot> slots_;
  std::uint64_t next_ = 0;         ///< block that no thread has taken
  std::uint64_t handed_over_ = 0;  ///< number of blocks passed on
  std::vector<std::jthread> threads_;
};

}  // namespace

}  // namespace assur::mechanism::campaign

namespace assur::mechanism {

ItemRange part_of(std::uint64_t items, std::uint64_t number, std::uint64_t parts) {
  const auto end_of = [items, parts](std::uint64_t part) {
    return items / parts * part + items % parts * part / parts;
  };
  return {end_of(number - 1), end_of(number)};
}

void run_campaign(const Campaign& campaign, ItemRange items, int threads,
                  const std::function<std::string(const std::vector<double>&)>& encode,
                  const std::function<void(const RowBlock&)>& use) {
  const campaign::Blocks blocks{items};
  if (threads > 1 && blocks.count() > 1) {
    campaign::Pipeline(campaign, blocks, threads, encode).hand_over(use);
    return;
  }
  const Campaign::Worker worker = campaign.worker();
  RowBlock block;
  for (std::uint64_t number = 0; number < blocks.count(); ++number) {
    campaign::compute(worker, blocks.range(number), encode, block);
    use(block);
  }
}

}  // namespace assur::mechanism
