#pragma once

#include "modbus_pdu.h"
#include "modbus_register_map.h"
#include "virtual_sensor.h"

#include <QByteArray>
#include <QList>

namespace lds::emulator {

/// What a sensor answers to one Modbus message (§5.2.2, §5.2.3), over whatever line it came.
class ModbusResponder {
public:
    explicit ModbusResponder(VirtualSensor& sensor);

    /// The answer to a PDU: a normal response or an exception.
    QByteArray answer(const QByteArray& pdu);

    /// Order of the two registers of a 4-byte item. The manual's figure is lost; SLMP says low word first.
    void setLowWordFirst(bool lowWordFirst) { m_lowWordFirst = lowWordFirst; }

private:
    using Answer = tl::expected<modbus::Response, modbus::Exception>;

    Answer carryOut(const modbus::Request& request);
    Answer readCoils(const modbus::Request& request);
    Answer readRegisters(const modbus::Request& request);
    Answer writeSingle(const modbus::Request& request);
    Answer writeMultiple(const modbus::Request& request);
    quint16 registerValue(const ModbusRegisterMap::Place& place) const;
    /// The writes that a multiple write's registers make, or why it cannot be carried out.
    tl::expected<QList<ItemWrite>, modbus::Exception> collectWrites(const modbus::Request& request) const;

    VirtualSensor& m_sensor;
    ModbusRegisterMap m_map;
    bool m_lowWordFirst = true;
};

} // namespace lds::emulator
