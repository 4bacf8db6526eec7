#pragma once

#include "solver/neighbours/neighbour_lists.h"

#include <algorithm>
#include <memory>
#include <mutex>

namespace plumbline {

/// Neighbours of n queries, each row as it was found, in blocks of memory that the next search uses
/// again. The same neighbours as in NeighbourLists, whose rows ascend and follow one another, in a
/// fraction of the time: nothing is sorted, nothing is moved, nothing is found twice.
/// Within a row the order is that of the search; it depends on the points, not on the threads.
class PackedLists {
    struct Block;

public:
    std::size_t size() const { return rows_.size(); }
    std::span<const Index> of(Index i) const { return {rows_[i].first, rows_[i].length}; }
    /// The length of all rows together.
    std::size_t pairs() const {
        std::size_t all = 0;
        for (const Row& row : rows_) all += row.length;
        return all;
    }
    /// Bytes held, those kept for the next search included.
    std::size_t memory() const { return rows_.capacity() * sizeof(Row) + pool_->memory(); }

    /// Forgets all rows, keeps their memory, and expects n new ones, each from a Writer.
    void restart(std::size_t n) {
        rows_.assign(n, {});
        pool_->restart();
    }

    /// Writes rows into a block of its own; one for each thread or task.
    class Writer {
    public:
        explicit Writer(PackedLists& lists) : lists_{lists} {}
        Writer(const Writer&) = delete;
        Writer& operator=(const Writer&) = delete;
        ~Writer() { close(); }

        /// Where the next row begins; it may have up to `most` elements.
        Index* room(std::size_t most) {
            if (static_cast<std::size_t>(end_ - at_) < most) {
                close();
                block_ = lists_.pool_->take(most);
                at_ = block_->memory.get() + block_->used;
                end_ = block_->memory.get() + block_->room;
            }
            return at_;
        }
        /// Row i will be added soon. Rows are added in the order of the search, which is no order at all if
        /// the points are not sorted: without this, waiting for memory takes as long as the search.
        void expect(Index i) const { __builtin_prefetch(&lists_.rows_[i], 1); }
        /// Row i is the next n elements.
        void add(Index i, std::size_t n) {
            lists_.rows_[i] = {at_, static_cast<Index>(n)};
            at_ += n;
        }

    private:
        void close() {
            if (block_ == nullptr) return;
            block_->used = static_cast<std::size_t>(at_ - block_->memory.get());
            lists_.pool_->give_back(block_);
        }

        PackedLists& lists_;
        Block* block_ = nullptr;
        Index *at_ = nullptr, *end_ = nullptr;
    };

private:
    struct Row {
        const Index* first = nullptr;
        Index length = 0;
    };
    struct Block {
        std::unique_ptr<Index[]> memory;
        std::size_t room, used;
    };
    /// All blocks, and those that no writer has.
    class Pool {
    public:
        void restart() {
            idle_.clear();
            for (const auto& block : blocks_) {
                block->used = 0;
                idle_.push_back(block.get());
            }
        }
        Block* take(std::size_t most) {
            const std::scoped_lock lock(mutex_);
            for (std::size_t k = idle_.size(); k-- > 0;) {
                if (idle_[k]->room - idle_[k]->used < most) continue;
                Block* block = idle_[k];
                idle_.erase(idle_.begin() + static_cast<std::ptrdiff_t>(k));
                return block;
            }
            constexpr std::size_t usual_room = 1u << 16;
            const std::size_t room = std::max(usual_room, most);
            blocks_.push_back(std::make_unique<Block>(
                Block{std::make_unique_for_overwrite<Index[]>(room), room, 0}));
            return blocks_.back().get();
        }
        void give_back(Block* block) {
            const std::scoped_lock lock(mutex_);
            constexpr std::size_t worth_keeping = 1u << 10;
            if (block->room - block->used >= worth_keeping) idle_.push_back(block);
        }
        std::size_t memory() const {
            std::size_t all = 0;
            for (const auto& block : blocks_) all += block->room * sizeof(Index);
            return all;
        }

    private:
        std::mutex mutex_;
        std::vector<std::unique_ptr<Block>> blocks_;
        std::vector<Block*> idle_;
    };

    std::vector<Row> rows_;
    std::unique_ptr<Pool> pool_ = std::make_unique<Pool>();
};

/// The same rows, ascending and one after the other.
inline NeighbourLists ascending(const PackedLists& packed) {
    NeighbourLists lists;
    lists.offsets.assign(1, 0);
    lists.indices.reserve(packed.pairs());
    for (Index i = 0; i < packed.size(); ++i) {
        const auto row = packed.of(i);
        lists.indices.insert(lists.indices.end(), row.begin(), row.end());
        std::sort(lists.indices.end() - static_cast<std::ptrdiff_t>(row.size()),
                  lists.indices.end());
        lists.offsets.push_back(lists.indices.size());
    }
    return lists;
}

}  // namespace plumbline
