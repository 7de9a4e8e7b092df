// A plugin of qemu that counts the instructions of a program, and writes their number to standard error at its end.
//
// The declarations are those of qemu-plugin.h that have not changed since qemu 6.0, because Debian ships no such
// header.

#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#ifndef PLUGIN_VERSION
#define PLUGIN_VERSION 1
#endif
#define EXPORTED __attribute__((visibility("default")))

extern "C" {

using PluginId = uint64_t;
struct qemu_plugin_tb;

EXPORTED int qemu_plugin_version = PLUGIN_VERSION;

void qemu_plugin_register_vcpu_tb_trans_cb(PluginId id, void (*translated)(PluginId id, qemu_plugin_tb *block));
void qemu_plugin_register_vcpu_tb_exec_cb(
		qemu_plugin_tb *block, void (*executed)(unsigned int processor, void *data), int flags, void *data);
void qemu_plugin_register_atexit_cb(PluginId id, void (*ended)(PluginId id, void *data), void *data);
std::size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb *block);
}

namespace {

constexpr int NO_REGISTERS = 0; // QEMU_PLUGIN_CB_NO_REGS
uint64_t total = 0; // The program has one thread.

void add(unsigned int, void *instructions) {
	total += reinterpret_cast<std::uintptr_t>(instructions);
}

void count_block(PluginId, qemu_plugin_tb *block) {
	const std::uintptr_t instructions = qemu_plugin_tb_n_insns(block);
	qemu_plugin_register_vcpu_tb_exec_cb(block, add, NO_REGISTERS, reinterpret_cast<void *>(instructions));
}

void print_total(PluginId, void *) {
	std::fprintf(stderr, "%" PRIu64 "\n", total);
}

} // namespace

extern "C" EXPORTED int qemu_plugin_install(PluginId id, const void *, int, char **) {
	qemu_plugin_register_vcpu_tb_trans_cb(id, count_block);
	qemu_plugin_register_atexit_cb(id, print_total, nullptr);
	return 0;
}
