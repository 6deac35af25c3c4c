// Stands in for OpenSSL's header in the preset web: the one digest that is used here, computed by the C library's code
// (cmake/web/sha256.c).
#pragma once

#include <cstddef>

struct EVP_MD {};
struct ENGINE;

extern "C" void clearcut_sha256(const void* data, unsigned long count, unsigned char* digest);

inline const EVP_MD* EVP_sha256() {
  static const EVP_MD sha256;
  return &sha256;
}

inline int EVP_Digest(const void* data, std::size_t count, unsigned char* digest, unsigned int* size,
                      const EVP_MD* /*kind*/, ENGINE* /*engine*/) {
  clearcut_sha256(data, static_cast<unsigned long>(count), digest);
  if (size != nullptr) *size = 32;
  return 1;
}
