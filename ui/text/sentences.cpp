#include "sentences.h"

#include "item_text.h"
#include "sentence_parts.h"

namespace lds::ui {

using catalog::ItemId;
using catalog::Role;
using catalog::SettingItem;

QString parseFailureSentence(const SettingItem& item, catalog::SensorModel model,
                             const settings::ParseFailure& failure, const QString& text)
{
    const QString name = itemName(item);
    const QString range = limitsText(item, model);
    const QString typed = text.trimmed();
    switch (failure.error) {
    case settings::ParseError::Empty:
        return Sentences::tr("%1: nothing is entered. Enter a value: %2.").arg(name, range);
    case settings::ParseError::NotANumber:
        return Sentences::tr("%1: “%2” is not a number. Enter a value: %3.").arg(name, typed, range);
    case settings::ParseError::TooManyDecimals:
        return Sentences::tr("%1: “%2” has more than the four decimals the sensor can take. Shorten it.")
            .arg(name, typed);
    case settings::ParseError::OutOfRange:
        return Sentences::tr("%1: “%2” is out of range. Enter a value: %3.").arg(name, typed, range);
    case settings::ParseError::NotAChoice:
        return Sentences::tr("%1: “%2” is none of its choices. Choose one of: %3.")
            .arg(name, typed, rangeText(item, model));
    }
    return {};
}

QString failureSentence(const ports::Failure& failure, const SettingItem* item)
{
    const QString where = item ? itemName(*item) : Sentences::tr("The sensor");
    switch (failure.code) {
    case ports::FailureCode::None:
        return {};
    case ports::FailureCode::FunctionNotSupported:
        return Sentences::tr("%1: the sensor does not know this kind of request (error 01). Check that it is "
                             "an HL-G2 with communication.")
            .arg(where);
    case ports::FailureCode::AddressRefused:
        return Sentences::tr("%1: the sensor refused the address (error 02). This type or version may not "
                             "have the item.")
            .arg(where);
    case ports::FailureCode::ValueRefused:
        return Sentences::tr("%1: the sensor refused the value (error 03): out of range, or it contradicts "
                             "another setting. Read all, then check the value.")
            .arg(where);
    case ports::FailureCode::NotReady:
        return Sentences::tr(
                   "%1: the sensor is not ready (error 04): it is in its menu, busy saving, or could "
                   "not carry it out now. Return it to the measurement display and try again.")
            .arg(where);
    case ports::FailureCode::OtherRefusal:
        return Sentences::tr("%1: the sensor refused with error %2, which its manual does not list. Read all "
                             "to see what it holds.")
            .arg(where, QStringLiteral("%1").arg(failure.wireCode, 2, 16, QLatin1Char('0')).toUpper());
    case ports::FailureCode::NoAnswer:
        return Sentences::tr("%1: no answer came, so it is not known whether it was carried out. It is not "
                             "repeated; read all to see what the sensor holds.")
            .arg(where);
    case ports::FailureCode::Malformed:
        return Sentences::tr("%1: the answer was cut short or belongs to another request. Read all to see "
                             "what the sensor holds.")
            .arg(where);
    case ports::FailureCode::ConnectionLost:
        return Sentences::tr(
                   "%1: the connection was cut before the answer, so it is not known whether it was "
                   "carried out. After reconnecting, compare with what the sensor holds.")
            .arg(where);
    case ports::FailureCode::NotConnected:
        return Sentences::tr("%1: there is no connection. Connect, then try again.").arg(where);
    case ports::FailureCode::NotReachable:
        return Sentences::tr("%1: this protocol has no address for it. Set it with the sensor's keys.")
            .arg(where);
    case ports::FailureCode::ViewOnly:
        return Sentences::tr(
                   "%1: this connection is for viewing only and never writes. Connect again without "
                   "“view only” to change it.")
            .arg(where);
    }
    return {};
}

QString openFailureSentence(const ports::LinkReport& report, const ports::ConnectionUrl& url)
{
    const QString where = url.place();
    const bool isSerial = url.protocol == ports::Protocol::ModbusRtu;
    switch (report.failure) {
    case ports::OpenFailure::None:
        return {};
    case ports::OpenFailure::HostNotFound:
        return Sentences::tr("No host named “%1” is known. Check the spelling, or enter the sensor's IP "
                             "address (menu 71).")
            .arg(url.host);
    case ports::OpenFailure::Refused:
        return Sentences::tr(
                   "%1 refused the connection: nothing listens on port %2. Compare with the ports in "
                   "the sensor's menu (74 tool, 75 Modbus).")
            .arg(url.host)
            .arg(url.port);
    case ports::OpenFailure::NoAnswer:
        if (isSerial)
            return Sentences::tr("%1 does not answer. Check power and cable, and that device address, speed "
                                 "and parity are the sensor's (menu 82 to 84).")
                .arg(where);
        return Sentences::tr("%1 does not answer. Check power, cable, and that the address is the sensor's "
                             "(menu 71).")
            .arg(where);
    case ports::OpenFailure::NotASensor:
        if (isSerial)
            return Sentences::tr("%1 answers, but not as an HL-G2 does. Check that the device address is the "
                                 "sensor's (menu 82).")
                .arg(where);
        return Sentences::tr("%1 answers, but not as an HL-G2 does. Check that the address and the port are "
                             "the sensor's.")
            .arg(where);
    case ports::OpenFailure::NotReady:
        return Sentences::tr("%1 is in its menu and does not answer requests. Leave the menu: hold ENTER for "
                             "2 seconds.")
            .arg(where);
    case ports::OpenFailure::Lost:
        return Sentences::tr("The connection to %1 was cut. Check power and cable; it is tried again by "
                             "itself.")
            .arg(where);
    case ports::OpenFailure::NoSuchPort:
        return Sentences::tr("There is no port %1. Plug the adapter in, or check the name.").arg(url.host);
    case ports::OpenFailure::PortBusy:
        return Sentences::tr("Another program is using the port %1. End that program, then try again.")
            .arg(url.host);
    case ports::OpenFailure::PortNotPermitted:
        return Sentences::tr("You are not allowed to open the port %1. On Linux, have your account added to "
                             "the group “dialout”, then log in again.")
            .arg(url.host);
    case ports::OpenFailure::PortUnusable:
        return Sentences::tr("%1 cannot be used as a serial port with %2 bps. Choose another port or another "
                             "speed.")
            .arg(url.host)
            .arg(url.serial.baud);
    case ports::OpenFailure::PortSettingsDiffer:
        return Sentences::tr("The port %1 is open for other sensors with another speed or parity, which all "
                             "sensors on a line share. Close those connections first, or use their settings.")
            .arg(url.host);
    case ports::OpenFailure::PortGone:
        return Sentences::tr("The port %1 is gone: its adapter was unplugged. Plug it in again; it is then "
                             "connected by itself.")
            .arg(url.host);
    }
    return {};
}

QString connectionWord(sensor::Connection connection)
{
    switch (connection) {
    case sensor::Connection::Closed:
        return Sentences::tr("Not connected");
    case sensor::Connection::Opening:
        return Sentences::tr("Connecting…");
    case sensor::Connection::Reading:
        return Sentences::tr("Reading settings…");
    case sensor::Connection::Ready:
        return Sentences::tr("Connected");
    case sensor::Connection::Reconnecting:
        return Sentences::tr("Reconnecting…");
    }
    return {};
}

QString savedWord(sensor::Saved saved)
{
    switch (saved) {
    case sensor::Saved::Unknown:
        return Sentences::tr("Not known whether saved");
    case sensor::Saved::Saved:
        return Sentences::tr("Saved");
    case sensor::Saved::NotSaved:
        return Sentences::tr("Not saved in the sensor");
    }
    return {};
}

QString unreachableReason(const SettingItem& item, const sensor::SensorSession& session)
{
    if (!item.modbus && !item.slmp && !item.eip) {
        return item.kind == catalog::Kind::MacAddress
                   ? Sentences::tr("Fixed by the maker; the sensor shows it in menu %1.").arg(item.menu)
                   : Sentences::tr(
                         "No protocol has an address for it. Set it with the sensor's keys, menu %1.")
                         .arg(item.menu);
    }
    if (item.role == Role::Status)
        return Sentences::tr("The sensor reports it; it cannot be set.");
    if (!session.reaches(item.id) && session.connection() != sensor::Connection::Closed &&
        session.connection() != sensor::Connection::Opening)
        return Sentences::tr("Not reachable over this protocol. Set it with the sensor's keys, or connect "
                             "over another protocol.");
    if (item.access == catalog::Access::Read)
        return Sentences::tr("The sensor reports it; it cannot be set.");
    if (session.isViewOnly())
        return Sentences::tr(
            "This connection is for viewing only. Connect again without “view only” to change "
            "it.");
    if (item.role == Role::Procedure)
        return Sentences::tr("Starts a procedure that waits for workpieces. Start it with the sensor's keys "
                             "(manual §%1).")
            .arg(QString::fromLatin1(item.section));
    return {};
}

} // namespace lds::ui
