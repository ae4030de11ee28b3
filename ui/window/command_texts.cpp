#include "command_texts.h"

#include "item_text.h"

#include <QCoreApplication>

namespace lds::ui {

using catalog::ItemId;
using catalog::Value;
using sensor::SensorSession;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lds::ui::CommandTexts)
};

QString address(const SensorSession& session)
{
    QList<Value> octets;
    for (const ItemId id : {ItemId::IpAddress1stOctet, ItemId::IpAddress2ndOctet, ItemId::IpAddress3rdOctet,
                            ItemId::IpAddress4thOctet})
        octets += session.held(id).value_or(0);
    return octetsText(octets);
}

QString editsNote(const SensorSession& session)
{
    const int edits = session.pending().count();
    return edits == 0 ? QString()
                      : QStringLiteral("\n\n") +
                            Words::tr("Your edits that are not applied (%1) stay as they are.").arg(edits);
}

} // namespace

bool needsQuestion(ItemId item)
{
    return item == ItemId::SettingsInitialization || item == ItemId::BankCopy ||
           item == ItemId::ResettingCommunicationSettings;
}

CommandQuestion commandQuestion(ItemId item, Value value, const SensorSession& session)
{
    const QString choice = displayValue(session.catalog().item(item), session.model(), value);
    switch (item) {
    case ItemId::SettingsInitialization:
        return {Words::tr("Initialise %1 of %2?").arg(choice, session.name()),
                Words::tr("The settings go back to their factory values at once, and this cannot be undone. "
                          "Ethernet and RS-485 settings stay as they are.") +
                    editsNote(session),
                Words::tr("Initialise")};
    case ItemId::BankCopy:
        return {Words::tr("Copy %1 in %2?").arg(choice, session.name()),
                Words::tr("What is saved in the first bank overwrites the second at once and outlasts "
                          "power-off; this cannot be undone. Changes that are not saved are not copied.") +
                    editsNote(session),
                Words::tr("Copy")};
    default:
        return {
            Words::tr("Reset the communication settings of %1?").arg(session.name()),
            Words::tr("The sensor takes up the communication settings it holds and this connection breaks. "
                      "Afterwards it is at %1, Modbus port %2, tool port %3.")
                    .arg(address(session))
                    .arg(session.held(ItemId::PortModbus).value_or(0))
                    .arg(session.held(ItemId::PortTool).value_or(0)) +
                editsNote(session),
            Words::tr("Reset")};
    }
}

QString whyNotNow(const SensorSession& session)
{
    if (session.isViewOnly())
        return Words::tr("%1 is connected for viewing only. Remove it and connect again without “view only”.")
            .arg(session.name());
    if (!session.isReady())
        return Words::tr("%1 is not connected just now. Wait for the connection, then try again.")
            .arg(session.name());
    if (session.isSensorNotReady())
        return Words::tr("%1 is in its menu or busy. Return it to the measurement display (hold ENTER for 2 "
                         "seconds), then try again.")
            .arg(session.name());
    if (session.isApplying() || session.isRunning() || !session.canWrite())
        return Words::tr("%1 is still being written to. Wait until that is done, then try again.")
            .arg(session.name());
    return {};
}

QString underWayText(const catalog::SettingItem& item)
{
    return item.id == ItemId::SetValueSaving ? Words::tr("Saving in the sensor…")
                                             : Words::tr("%1…").arg(itemName(item));
}

QString doneText(const catalog::SettingItem& item, Value value, catalog::SensorModel model)
{
    switch (item.id) {
    case ItemId::SetValueSaving:
        return Words::tr("Saved in the sensor.");
    case ItemId::MeasuredValueResetting:
        return Words::tr("The measured value was reset.");
    case ItemId::LaserStop:
        return value == 0 ? Words::tr("The laser is on.") : Words::tr("The laser is off.");
    case ItemId::ZeroSetting:
        return value == 0 ? Words::tr("The zero set is cleared.") : Words::tr("The zero is set.");
    case ItemId::KeyLock:
        return value == 0 ? Words::tr("The sensor's keys are unlocked.")
                          : Words::tr("The sensor's keys are locked.");
    case ItemId::ResettingCommunicationSettings:
        return Words::tr("The communication settings take effect.");
    default:
        break;
    }
    const QString choice = displayValue(item, model, value);
    return choice.isEmpty() ? Words::tr("%1: done.").arg(itemName(item))
                            : Words::tr("%1: %2.").arg(itemName(item), choice);
}

} // namespace lds::ui
