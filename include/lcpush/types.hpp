// lcpush: the few types that every header shares. No heap, no exceptions, no iostream.
#pragma once

#include <Eigen/Core>
#include <iterator>

namespace lcpush {

using Index = Eigen::Index;

template <class S> using Vector3 = Eigen::Matrix<S, 3, 1>;
template <class S> using Matrix3 = Eigen::Matrix<S, 3, 3>;
/// A twist [linear; angular] or a wrench [force; moment]. The reference point is always the
/// object's centre of mass, the axes are always the scene's.
template <class S> using Vector6 = Eigen::Matrix<S, 6, 1>;
template <class S> using Matrix6 = Eigen::Matrix<S, 6, 6>;

// Views over memory that the caller owns (column-major, as everywhere in lcpush).
template <class S> using VectorMap = Eigen::Map<Eigen::Matrix<S, Eigen::Dynamic, 1>>;
template <class S> using MatrixMap = Eigen::Map<Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>>;

/// A pointer and a length: an array that somebody else owns.
template <class T> struct Span {
  T* data = nullptr;
  Index size = 0;

  T& operator[](Index i) const { return data[i]; }
  T* begin() const { return data; }
  T* end() const { return data + size; }
};

/// The indices from `first` on, to loop over.
struct Indices {
  struct Iterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = Index;
    using difference_type = Index;
    using pointer = const Index*;
    using reference = Index;

    Index i;
    Index operator*() const { return i; }
    Iterator& operator++() { return ++i, *this; }
    bool operator==(const Iterator& other) const { return i == other.i; }
    bool operator!=(const Iterator& other) const { return i != other.i; }
  };

  Index first, count;
  Iterator begin() const { return {first}; }
  Iterator end() const { return {first + count}; }
};

} // namespace lcpush
