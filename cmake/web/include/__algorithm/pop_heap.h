// std::pop_heap as g++'s standard library has it; see clearcut_order.h. The library's own takes another name.
#pragma once

#include <__algorithm/comp.h>
#include <__algorithm/comp_ref_type.h>
#include <__algorithm/sift_down.h>
#include <__algorithm/unwrap_iter.h>
#include <__iterator/iterator_traits.h>
#include <clearcut_order.h>

#include <type_traits>

#define pop_heap clearcut_other_pop_heap
#include_next <__algorithm/pop_heap.h>
#undef pop_heap

_LIBCPP_BEGIN_NAMESPACE_STD

template <class It, class Less>
inline _LIBCPP_CONSTEXPR_AFTER_CXX17 void pop_heap(It first, It last, Less less) {
  clearcut_order::pop_heap(first, last, less);
}
template <class It>
inline _LIBCPP_CONSTEXPR_AFTER_CXX17 void pop_heap(It first, It last) {
  _VSTD::pop_heap(first, last, __less<typename iterator_traits<It>::value_type>());
}

_LIBCPP_END_NAMESPACE_STD
