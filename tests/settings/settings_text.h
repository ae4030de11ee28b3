#pragma once

#include "rules.h"

#include <QString>

/// Words for failure messages, and short ways to write addresses.
namespace lds::settings::test {

QString text(const Values& values);
QString text(const Write& write);
QString text(const QList<Write>& steps);
QString text(const QList<Refusal>& refusals);

/// The octets of an address as values of its group, from "192.168.1.6".
Values address(catalog::WriteGroup group, const char* dotted);
Write addressWrite(catalog::WriteGroup group, const char* dotted);

/// One laid over the other.
Values operator+(const Values& below, const Values& above);

/// Every setting at its factory default.
Values factorySettings(catalog::SensorModel model);

} // namespace lds::settings::test
