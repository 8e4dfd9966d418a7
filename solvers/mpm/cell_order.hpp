#pragma once
#include <algorithm>
#include <array>
#include <vector>

namespace touchstone::mpm {

/// Keeps particles in blocks of `width` neighbouring cells of a row, one cell a lane: the k-th particle of every cell
/// of a block lies side by side with the k-th of the others. Only blocks that hold particles are there.
///
/// A particle that goes to another cell is put behind the others there, and the last of the cell that it left fills the
/// hole. A block that is full moves to a place with more room; when there is none, all are laid out anew. The work is
/// that of the particles that move and, when blocks come or go, that of all blocks that hold particles: cells without
/// cost nothing.
template <int width_>
class CellOrder {
 public:
  static constexpr int width = width_;  // cells in a block

  class Block {
   public:
    static constexpr bool is_single = false;

    Block(int its_row, int its_column) : row(its_row), column(its_column) {}

    int row, column;  // of its first cell
    int first = 0;    // slot of the first particle of its first cell
    int capacity = 0;
    std::array<int, width> count{};  // particles of each cell

    int slot(int lane, int k) const { return first + k * width + lane; }
    int least() const { return least_; }  // particles in a cell
    int most() const { return most_; }
    void add(int lane, int particles) {
      count[lane] += particles;
      least_ = *std::min_element(count.begin(), count.end());
      most_ = *std::max_element(count.begin(), count.end());
    }

   private:
    int least_ = 0, most_ = 0;
  };

  /// A block known to hold one particle in each of its cells: loops over its particles dissolve.
  class Single : public Block {
   public:
    static constexpr bool is_single = true;

    explicit Single(const Block& block) : Block(block) {}

    static constexpr int least() { return 1; }
    static constexpr int most() { return 1; }
  };

  /// Makes room for particles of which `cell_of` names the cell of each, cells numbered row by row.
  CellOrder(int columns, int rows, const std::vector<int>& cell_of)
      : columns_(columns), index_of_((columns + width - 1) / width * rows, -1) {
    for (int cell : cell_of) block_of(cell).add(lane_of(cell), 1);
    list_occupied();
    find_room();
  }

  int count(int cell) const {
    const int index = index_of_[number_of(cell)];
    return index < 0 ? 0 : blocks_[index].count[lane_of(cell)];
  }
  /// Of the k-th particle of a cell.
  int slot(int cell, int k) const { return blocks_[index_of_[number_of(cell)]].slot(lane_of(cell), k); }
  int cell(const Block& block, int lane) const { return block.row * columns_ + block.column + lane; }
  int slots() const { return slots_; }

  /// Calls f(cell, slot) for every particle.
  template <class F>
  void for_each(const F& f) const {
    for (const Block& block : blocks_)
      for (int lane = 0; lane < width; ++lane)
        for (int k = 0; k < block.count[lane]; ++k) f(cell(block, lane), block.slot(lane, k));
  }

  /// The blocks that hold particles, row by row, as of the last `list_occupied`; those that came since stand behind.
  const std::vector<Block>& blocks() const { return blocks_; }
  /// Where in `blocks` each row begins, and the end.
  const std::vector<int>& rows() const { return rows_; }
  /// Calls work(block_at) for the blocks from `begin` to `end` of a row, where block_at(i) is the i-th block: as a
  /// `Single` if every cell of the row has one particle.
  template <class Work>
  void with_row(int begin, int end, const Work& work) const {
    const auto one_each = [](const Block& block) { return block.least() == 1 && block.most() == 1; };
    if (std::all_of(&blocks_[begin], &blocks_[end - 1] + 1, one_each))
      work([this](int i) { return Single(blocks_[i]); });
    else
      work([this](int i) -> const Block& { return blocks_[i]; });
  }
  /// True if a block has come or has been emptied since then.
  bool is_stale() const { return stale_; }

  void list_occupied() {
    for (const Block& block : blocks_) index_of_[number_of(block)] = -1;
    std::erase_if(blocks_, [](const Block& block) { return block.most() == 0; });
    std::sort(blocks_.begin(), blocks_.end(),
              [&](const Block& a, const Block& b) { return number_of(a) < number_of(b); });
    rows_.clear();
    for (int i = 0; i < static_cast<int>(blocks_.size()); ++i) {
      index_of_[number_of(blocks_[i])] = i;
      if (i == 0 || blocks_[i].row != blocks_[i - 1].row) rows_.push_back(i);
    }
    rows_.push_back(static_cast<int>(blocks_.size()));
    stale_ = false;
  }

  /// Takes the k-th particle of a cell to another cell. `particles` offers for_fields(f), which calls f for each of its
  /// fields, one value per slot.
  template <class Particles>
  void carry(Particles& particles, int from, int k, int to) {
    const int place = free_slot(particles, to);
    Block& source = block_of(from);
    const int lane = lane_of(from);
    source.add(lane, -1);
    const int left = source.slot(lane, k), last = source.slot(lane, source.count[lane]);
    copy(particles, left, place);
    if (last != left) copy(particles, last, left);
    clear(particles, last);
    block_of(to).add(lane_of(to), 1);
    stale_ = stale_ || source.most() == 0;
  }

 private:
  int number_of(int row, int column) const { return row * ((columns_ + width - 1) / width) + column / width; }
  int number_of(int cell) const { return number_of(cell / columns_, cell % columns_); }
  int number_of(const Block& block) const { return number_of(block.row, block.column); }
  int lane_of(int cell) const { return cell % columns_ % width; }

  /// A block without room, if it is new.
  Block& block_of(int cell) {
    int& index = index_of_[number_of(cell)];
    if (index < 0) {
      index = static_cast<int>(blocks_.size());
      const int column = cell % columns_;
      blocks_.emplace_back(cell / columns_, column - column % width);
      stale_ = true;
    }
    return blocks_[index];
  }

  template <class Particles>
  int free_slot(Particles& particles, int cell) {
    Block& block = block_of(cell);
    const int lane = lane_of(cell);
    if (block.count[lane] == block.capacity) make_room(particles, block);
    return block.slot(lane, block.count[lane]);
  }

  template <class Particles>
  void make_room(Particles& particles, Block& block) {
    const int capacity = block.capacity + block.capacity / 4 + 2;
    if (used_ + capacity * width > slots_) return lay_out_anew(particles);
    for (int lane = 0; lane < width; ++lane)
      for (int k = 0; k < block.count[lane]; ++k) {
        copy(particles, block.slot(lane, k), used_ + k * width + lane);
        clear(particles, block.slot(lane, k));
      }
    block.first = used_;
    block.capacity = capacity;
    used_ += capacity * width;
  }

  template <class Particles>
  static void copy(Particles& particles, int from, int to) {
    particles.for_fields([=](auto& field) { field[to] = field[from]; });
  }
  template <class Particles>
  static void clear(Particles& particles, int slot) {
    particles.for_fields([=](auto& field) { field[slot] = 0; });
  }

  template <class Particles>
  void lay_out_anew(Particles& particles) {
    std::vector<int> from;  // of each block
    for (const Block& block : blocks_) from.push_back(block.first);
    find_room();
    particles.for_fields([&]<class F>(F& field) {
      F fresh(slots_);
      std::fill_n(&fresh[0], slots_, 0);
      for (std::size_t i = 0; i < blocks_.size(); ++i)
        std::copy_n(&field[from[i]], blocks_[i].most() * width, &fresh[blocks_[i].first]);
      field.swap(fresh);
    });
  }

  /// Gives every block a place with room for one particle more in each of its cells, and for a quarter more.
  void find_room() {
    used_ = 0;
    for (Block& block : blocks_) {
      block.first = used_;
      block.capacity = block.most() + block.most() / 4 + 1;
      used_ += block.capacity * width;
    }
    slots_ = used_ + used_ / 8 + 64 * width;  // the rest is for blocks that come or grow
  }

  int columns_;
  std::vector<int> index_of_;  // of each block of the grid, in blocks_; -1 for one that is not there
  std::vector<Block> blocks_;
  std::vector<int> rows_;
  int used_ = 0, slots_ = 0;
  bool stale_ = false;
};

}  // namespace touchstone::mpm
