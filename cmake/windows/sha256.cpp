#include <openssl/evp.h>
#include <windows.h>
// After windows.h, whose types it uses.
#include <bcrypt.h>

#include <algorithm>

const EVP_MD* EVP_sha256() {
  static const EVP_MD sha256;
  return &sha256;
}

int EVP_Digest(const void* data, std::size_t count, unsigned char* digest, unsigned int* size,
               const EVP_MD* /*kind*/, ENGINE* /*engine*/) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  constexpr ULONG kBytes = 32;
  BCRYPT_ALG_HANDLE sha256 = nullptr;
  BCRYPT_HASH_HANDLE hash = nullptr;
  bool done = BCryptOpenAlgorithmProvider(&sha256, BCRYPT_SHA256_ALGORITHM, nullptr, 0) == 0 &&
              BCryptCreateHash(sha256, &hash, nullptr, 0, nullptr, 0, 0) == 0;
  auto* next = static_cast<UCHAR*>(const_cast<void*>(data));
  while (done && count > 0) {
    const std::size_t taken = std::min(count, kMost);
    done = BCryptHashData(hash, next, static_cast<ULONG>(taken), 0) == 0;
    next += taken;
    count -= taken;
  }
  done = done && BCryptFinishHash(hash, digest, kBytes, 0) == 0;
  if (hash != nullptr) BCryptDestroyHash(hash);
  if (sha256 != nullptr) BCryptCloseAlgorithmProvider(sha256, 0);
  if (size != nullptr) *size = kBytes;
  return done ? 1 : 0;
}
