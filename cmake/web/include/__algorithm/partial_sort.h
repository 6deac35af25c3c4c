// std::partial_sort as g++'s standard library has it; see clearcut_order.h. The library's own takes another name.
#pragma once

#include <__algorithm/comp.h>
#include <__algorithm/comp_ref_type.h>
#include <__algorithm/make_heap.h>
#include <__algorithm/sift_down.h>
#include <__algorithm/sort_heap.h>
#include <__algorithm/unwrap_iter.h>
#include <__iterator/iterator_traits.h>
#include <clearcut_order.h>

#include <type_traits>

#define partial_sort clearcut_other_partial_sort
#include_next <__algorithm/partial_sort.h>
#undef partial_sort

_LIBCPP_BEGIN_NAMESPACE_STD

template <class It, class Less>
inline _LIBCPP_CONSTEXPR_AFTER_CXX17 void partial_sort(It first, It middle, It last, Less less) {
  clearcut_order::partial_sort(first, middle, last, less);
}
template <class It>
inline _LIBCPP_CONSTEXPR_AFTER_CXX17 void partial_sort(It first, It middle, It last) {
  _VSTD::partial_sort(first, middle, last, __less<typename iterator_traits<It>::value_type>());
}

_LIBCPP_END_NAMESPACE_STD
