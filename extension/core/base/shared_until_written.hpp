#pragma once

#include <memory>

namespace undergrowth {

/// Copy-on-write value. Copies may be destroyed on other threads. Sharing is recorded when a copy is made, in both
/// objects, and does not depend on the reference count: another thread may still read when the count falls. Copying
/// therefore writes to its source, so one object belongs to one thread at a time.
template <class Value> class SharedUntilWritten {
public:
	SharedUntilWritten() : value(std::make_shared<Value>()) {}
	SharedUntilWritten(const SharedUntilWritten &other) : value(other.value), is_shared(true) {
		other.is_shared = true;
	}
	SharedUntilWritten &operator=(const SharedUntilWritten &other) {
		value = other.value;
		is_shared = other.is_shared = true;
		return *this;
	}
	/// A moved-from object may only be assigned to or destroyed.
	SharedUntilWritten(SharedUntilWritten &&) noexcept = default;
	SharedUntilWritten &operator=(SharedUntilWritten &&) noexcept = default;
	~SharedUntilWritten() = default;

	const Value &operator*() const { return *value; }
	const Value *operator->() const { return value.get(); }

	/// Returns the value for writing; copies do not change.
	Value &own() {
		if (is_shared) {
			value = std::make_shared<Value>(*value);
			is_shared = false;
		}
		return *value;
	}

private:
	std::shared_ptr<Value> value;
	mutable bool is_shared = false;
};

} // namespace undergrowth
