#pragma once
#include <numeric>
#include <vector>

namespace touchstone::mpm {

/// Keeps particles in the order of their cells: cell c holds the slots from begin(c) to end(c).
///
/// A particle that goes to another cell is carried there past all cells between: each moves over by one slot by handing
/// one particle from one end of its range to the other. Nothing is sorted and nothing allocated.
class CellOrder {
 public:
  /// Makes room for particles of which `cell_of` names the cell of each.
  CellOrder(int cells, const std::vector<int>& cell_of) : first_(cells + 1, 0) {
    for (int cell : cell_of) ++first_[cell + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    occupied_.reserve(cells);
    list_occupied();
  }

  int begin(int cell) const { return first_[cell]; }
  int end(int cell) const { return first_[cell + 1]; }
  int count(int cell) const { return end(cell) - begin(cell); }
  int cells() const { return static_cast<int>(first_.size()) - 1; }
  /// The cells that hold particles, ascending, as of the last `list_occupied`.
  const std::vector<int>& occupied() const { return occupied_; }
  /// True if a cell has been filled or emptied since then.
  bool is_stale() const { return stale_; }

  void list_occupied() {
    occupied_.clear();
    for (int cell = 0; cell < cells(); ++cell)
      if (begin(cell) < end(cell)) occupied_.push_back(cell);
    stale_ = false;
  }

  /// Takes the particle in `slot` from its cell to another. Carried upwards it leaves its slot to the last of its cell,
  /// downwards to the first. `particles` offers copy(from, to) and a spare() slot.
  template <class Particles>
  void carry(Particles& particles, int slot, int from, int to) {
    particles.copy(slot, particles.spare());
    int hole = slot;
    const auto fill_from = [&](int other) {
      if (other != hole) particles.copy(other, hole);
      hole = other;
    };
    for (int cell = from; cell < to; ++cell) fill_from(--first_[cell + 1]);
    for (int cell = from; cell > to; --cell) fill_from(first_[cell]++);
    particles.copy(particles.spare(), hole);
    stale_ = stale_ || begin(from) == end(from) || end(to) - begin(to) == 1;
  }

 private:
  std::vector<int> first_;
  std::vector<int> occupied_;
  bool stale_ = false;
};

}  // namespace touchstone::mpm
