// The transport over PVM; see pvm_transport.h. Bodies are bytes in the order of wire.h, so raw
// packing serves wherever all hosts share PVM's data format; else PVM's own encoding wraps them.
#include "parallel/pvm/pvm_transport.h"

#include <pvm3.h>

#include <cmath>

#include "parallel/pvm/pvm_call.h"

namespace rayshade::parallel {

namespace {

// PVM message tags. A message of the catalogue in frame f has kMessageTag + f.
enum PvmTag : int {
  kStartTag = 1,
  kPulseTag = 2,
  kLeaveTag = 3,
  kGoneTag = 4,
  kMessageTag = 1000,
};
constexpr int kFragmentBytes = 65536;

// Two programs understand each other where their catalogues are the same.
int CatalogueHash() {
  uint32_t hash = 2166136261u;
  for (const unsigned char c : CatalogueText()) hash = (hash ^ c) * 16777619u;
  return static_cast<int>(hash & 0x7fffffff);
}

void PackInts(std::vector<int> ints) {
  PvmCheck(pvm_pkint(ints.data(), static_cast<int>(ints.size()), 1), "pvm_pkint");
}

int UnpackInt() {
  int value = 0;
  if (pvm_upkint(&value, 1, 1) < 0) throw WireError("a PVM message that ends early");
  return value;
}

void SendEmpty(int tid, int tag) {
  PvmCheck(pvm_initsend(PvmDataRaw), "pvm_initsend");
  PvmCheck(pvm_send(tid, tag), "pvm_send");
}

}  // namespace

PvmTransport::PvmTransport(std::vector<int> tids, bool raw) : tids_(std::move(tids)), raw_(raw) {
  Enter();
  AskToBeToldOf(tids_);
  tids_.insert(tids_.begin(), PvmCheck(pvm_mytid(), "pvm_mytid"));
  for (size_t i = 0; i < tids_.size(); ++i) ids_[tids_[i]] = static_cast<ProcessId>(i);
}

PvmTransport::PvmTransport(int host_tid) : tids_{host_tid}, ids_{{host_tid, kHost}} {
  Enter();
  AskToBeToldOf(tids_);
}

void PvmTransport::Enter() {
  PvmCheck(pvm_setopt(PvmRoute, PvmRouteDirect), "pvm_setopt(PvmRoute)");
  PvmCheck(pvm_setopt(PvmFragSize, kFragmentBytes), "pvm_setopt(PvmFragSize)");
  ForgetSent();
}

void PvmTransport::ForgetSent() {
  ForEachMessage([this]<class Message>() {
    sent_[static_cast<size_t>(Message::kTag)] = {Message::kName, 0, 0};
  });
}

void PvmTransport::AskToBeToldOf(const std::vector<int>& tids) {
  std::vector<int> copy = tids;
  PvmCheck(pvm_notify(PvmTaskExit, kGoneTag, static_cast<int>(copy.size()), copy.data()),
           "pvm_notify(PvmTaskExit)");
}

void PvmTransport::StartFrame() {
  ++frame_;
  ForgetSent();
  for (size_t i = 1; i < tids_.size(); ++i) {
    PvmCheck(pvm_initsend(PvmDataDefault), "pvm_initsend");
    PackInts({CatalogueHash(), frame_, raw_, static_cast<int>(i), static_cast<int>(tids_.size())});
    PackInts(tids_);
    PvmCheck(pvm_send(tids_[i], kStartTag), "pvm_send(Start)");
  }
}

void PvmTransport::ReadStart() {
  if (UnpackInt() != CatalogueHash())
    throw WireError("prayshade and prayshade-trace are of different versions");
  frame_ = UnpackInt();
  ForgetSent();
  raw_ = UnpackInt() != 0;
  const int self = UnpackInt(), count = UnpackInt();
  if (self < 1 || self >= count || count > 65535) throw WireError("a Start that makes no sense");
  self_ = static_cast<ProcessId>(self);
  tids_.resize(count);
  ids_.clear();
  for (int i = 0; i < count; ++i) {
    tids_[i] = UnpackInt();
    ids_[tids_[i]] = static_cast<ProcessId>(i);
  }
}

void PvmTransport::SendLeave() {
  for (size_t i = 1; i < tids_.size(); ++i) SendEmpty(tids_[i], kLeaveTag);
}

void PvmTransport::SendPulse() { SendEmpty(tids_[kHost], kPulseTag); }

void PvmTransport::Send(ProcessId to, std::vector<uint8_t> bytes) {
  KindCount& count = sent_[static_cast<size_t>(TagOf(bytes))];
  ++count.messages;
  count.bytes += bytes.size();
  if (to == self_) {
    to_self_.push_back(std::move(bytes));
    return;
  }

  // A copy of a fragment costs less than sending its header by a call of its own, as in place.
  int length = static_cast<int>(bytes.size());
  const int raw = length < kFragmentBytes ? PvmDataRaw : PvmDataInPlace;
  PvmCheck(pvm_initsend(raw_ ? raw : PvmDataDefault), "pvm_initsend");
  if (!raw_) PvmCheck(pvm_pkint(&length, 1, 1), "pvm_pkint");
  PvmCheck(pvm_pkbyte(reinterpret_cast<char*>(bytes.data()), length, 1), "pvm_pkbyte");
  PvmCheck(pvm_send(tids_.at(to), kMessageTag + frame_), "pvm_send(" + count.name + ")");
}

void PvmTransport::Receive(double seconds, Arrival* arrival) {
  arrival->kind = Arrival::Kind::kNone;
  if (!to_self_.empty()) {
    arrival->kind = Arrival::Kind::kMessage;
    arrival->from = self_;
    arrival->bytes = std::move(to_self_.front());
    to_self_.pop_front();
    return;
  }
  timeval wait;
  wait.tv_sec = static_cast<time_t>(std::floor(seconds));
  wait.tv_usec = static_cast<suseconds_t>((seconds - std::floor(seconds)) * 1e6);
  for (;;) {
    const int buffer = seconds > 0 ? pvm_trecv(-1, -1, &wait) : pvm_nrecv(-1, -1);
    if (PvmCheck(buffer, "pvm_recv") == 0) return;
    const bool taken = Open(buffer, arrival);
    PvmCheck(pvm_freebuf(buffer), "pvm_freebuf");
    if (taken) return;
  }
}

bool PvmTransport::Open(int buffer, Arrival* arrival) {
  int length = 0, tag = 0, sender = 0;
  PvmCheck(pvm_bufinfo(buffer, &length, &tag, &sender), "pvm_bufinfo");

  // PVM's own notice names the task in its body.
  if (tag == kGoneTag) sender = UnpackInt();
  const auto known = ids_.find(sender);
  if (known == ids_.end()) return false;
  arrival->from = known->second;

  switch (tag) {
    case kGoneTag:
      arrival->kind = Arrival::Kind::kGone;
      return true;
    case kPulseTag:
      arrival->kind = Arrival::Kind::kPulse;
      return true;
    case kLeaveTag:
      arrival->kind = Arrival::Kind::kLeave;
      return arrival->from == kHost;
    case kStartTag:
      if (arrival->from != kHost) return false;
      ReadStart();
      arrival->kind = Arrival::Kind::kStart;
      return true;
    default:
      if (frame_ == 0 || tag != kMessageTag + frame_) return false;
      ReadBytes(length, &arrival->bytes);
      arrival->kind = Arrival::Kind::kMessage;
      return true;
  }
}

void PvmTransport::ReadBytes(int length, std::vector<uint8_t>* bytes) {
  const int count = raw_ ? length : UnpackInt();
  if (count < 0 || count > length) throw WireError("a PVM message of an impossible length");
  bytes->resize(count);
  if (count != 0 && pvm_upkbyte(reinterpret_cast<char*>(bytes->data()), count, 1) < 0)
    throw WireError("a PVM message that ends early");
}

}  // namespace rayshade::parallel
