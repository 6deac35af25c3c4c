// Sorting that leaves equal elements where g++'s standard library leaves them. std::sort, std::nth_element, std::partial_sort
// and heaps may put equal elements in any order, and libraries do so differently: programs of the web build would differ from
// those of the command where two passes are equally good. Steps: introsort [musser1997] with the median of the second, middle
// and last element as the pivot, insertion sort of what is at most 16 long; heaps by sifting a hole down to a leaf.
#pragma once

#include <iterator>
#include <utility>

namespace clearcut_order {

constexpr int kShort = 16;

template <typename It>
using Value = typename std::iterator_traits<It>::value_type;
template <typename It>
using Distance = typename std::iterator_traits<It>::difference_type;

template <typename Count>
constexpr int log2_of(Count n) {
  int power = 0;
  for (; n > 1; n /= 2) ++power;
  return power;
}

template <typename It, typename Less>
void sift_up(It first, Distance<It> hole, Distance<It> top, Value<It> value, Less& less) {
  Distance<It> parent = (hole - 1) / 2;
  while (hole > top && less(first[parent], value)) {
    first[hole] = std::move(first[parent]);
    hole = parent;
    parent = (hole - 1) / 2;
  }
  first[hole] = std::move(value);
}

template <typename It, typename Less>
void sift_down(It first, Distance<It> hole, Distance<It> count, Value<It> value, Less& less) {
  const Distance<It> top = hole;
  Distance<It> child = hole;
  while (child < (count - 1) / 2) {
    child = 2 * (child + 1);
    if (less(first[child], first[child - 1])) --child;
    first[hole] = std::move(first[child]);
    hole = child;
  }
  if ((count & 1) == 0 && child == (count - 2) / 2) {
    child = 2 * (child + 1);
    first[hole] = std::move(first[child - 1]);
    hole = child - 1;
  }
  sift_up(first, hole, top, std::move(value), less);
}

template <typename It, typename Less>
void make_heap(It first, It last, Less& less) {
  const Distance<It> count = last - first;
  for (Distance<It> parent = (count - 2) / 2; count >= 2 && parent >= 0; --parent) {
    Value<It> value = std::move(first[parent]);
    sift_down(first, parent, count, std::move(value), less);
  }
}

/// The greatest of the heap goes to `result`, whose element goes into the heap.
template <typename It, typename Less>
void exchange_top(It first, It last, It result, Less& less) {
  Value<It> value = std::move(*result);
  *result = std::move(*first);
  sift_down(first, Distance<It>(0), last - first, std::move(value), less);
}

template <typename It, typename Less>
void push_heap(It first, It last, Less& less) {
  Value<It> value = std::move(*(last - 1));
  sift_up(first, last - first - 1, Distance<It>(0), std::move(value), less);
}

template <typename It, typename Less>
void pop_heap(It first, It last, Less& less) {
  if (last - first > 1) exchange_top(first, last - 1, last - 1, less);
}

template <typename It, typename Less>
void sort_heap(It first, It last, Less& less) {
  for (; last - first > 1; --last) exchange_top(first, last - 1, last - 1, less);
}

template <typename It, typename Less>
void heap_select(It first, It middle, It last, Less& less) {
  clearcut_order::make_heap(first, middle, less);
  for (It i = middle; i < last; ++i)
    if (less(*i, *first)) exchange_top(first, middle, i, less);
}

template <typename It, typename Less>
void partial_sort(It first, It middle, It last, Less& less) {
  heap_select(first, middle, last, less);
  clearcut_order::sort_heap(first, middle, less);
}

template <typename It, typename Less>
void insert_before(It at, Less& less) {
  Value<It> value = std::move(*at);
  It next = at;
  for (--next; less(value, *next); --next) {
    *at = std::move(*next);
    at = next;
  }
  *at = std::move(value);
}

template <typename It, typename Less>
void insertion_sort(It first, It last, Less& less) {
  if (first == last) return;
  for (It i = first + 1; i != last; ++i) {
    if (less(*i, *first)) {
      Value<It> value = std::move(*i);
      for (It k = i; k != first; --k) *k = std::move(*(k - 1));
      *first = std::move(value);
    } else {
      insert_before(i, less);
    }
  }
}

template <typename It, typename Less>
It median(It a, It b, It c, Less& less) {
  if (less(*a, *b)) return less(*b, *c) ? b : less(*a, *c) ? c : a;
  return less(*a, *c) ? a : less(*b, *c) ? c : b;
}

template <typename It, typename Less>
It partitioned(It first, It last, Less& less) {
  const It middle = first + (last - first) / 2;
  std::iter_swap(first, median(first + 1, middle, last - 1, less));
  const It pivot = first++;
  for (;; ++first) {
    while (less(*first, *pivot)) ++first;
    --last;
    while (less(*pivot, *last)) --last;
    if (!(first < last)) return first;
    std::iter_swap(first, last);
  }
}

template <typename It, typename Less>
void introsort(It first, It last, int depth, Less& less) {
  while (last - first > kShort) {
    if (depth-- == 0) return clearcut_order::partial_sort(first, last, last, less);
    const It cut = partitioned(first, last, less);
    introsort(cut, last, depth, less);
    last = cut;
  }
}

template <typename It, typename Less>
void sort(It first, It last, Less& less) {
  if (first == last) return;
  introsort(first, last, 2 * log2_of(last - first), less);
  if (last - first <= kShort) return insertion_sort(first, last, less);
  insertion_sort(first, first + kShort, less);
  for (It i = first + kShort; i != last; ++i) insert_before(i, less);
}

template <typename It, typename Less>
void nth_element(It first, It nth, It last, Less& less) {
  if (first == last || nth == last) return;
  for (int depth = 2 * log2_of(last - first); last - first > 3;) {
    if (depth-- == 0) {
      heap_select(first, nth + 1, last, less);
      std::iter_swap(first, nth);
      return;
    }
    const It cut = partitioned(first, last, less);
    (cut <= nth ? first : last) = cut;
  }
  insertion_sort(first, last, less);
}

}  // namespace clearcut_order
