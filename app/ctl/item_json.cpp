#include "item_json.h"

#include "keys.h"
#include "value_text.h"

namespace lds::ctl {

namespace {

using namespace catalog;

QJsonValue numberOrNull(int number) { return number == 0 ? QJsonValue() : QJsonValue(number); }
QJsonValue textOrNull(const QString& text) { return text.isEmpty() ? QJsonValue() : QJsonValue(text); }

QJsonObject limitsJson(const SettingItem& item)
{
    QJsonObject models;
    for (const ModelDescription& model : Catalog::hlG2().models()) {
        const Limits& limits = item.limitsFor(model.model);
        models.insert(QString::fromLatin1(model.typeName),
                      QJsonObject{{QStringLiteral("minimum"), limits.minimum},
                                  {QStringLiteral("maximum"), limits.maximum},
                                  {QStringLiteral("default"),
                                   item.hasDefault ? QJsonValue(limits.defaultValue) : QJsonValue()},
                                  {QStringLiteral("resolution"), limits.resolution}});
    }
    return models;
}

QJsonArray choicesJson(const SettingItem& item)
{
    QJsonArray choices;
    for (const Choice& choice : item.choices) {
        QJsonArray models;
        for (const ModelDescription& model : Catalog::hlG2().models()) {
            if (choice.models & maskOf(model.model))
                models.append(QString::fromLatin1(model.typeName));
        }
        choices.append(QJsonObject{{QStringLiteral("code"), choice.code},
                                   {QStringLiteral("name"), QString::fromUtf8(choice.name)},
                                   {QStringLiteral("models"), models}});
    }
    return choices;
}

} // namespace

QString roleWord(Role role)
{
    switch (role) {
    case Role::Setting:
        return QStringLiteral("setting");
    case Role::Switch:
        return QStringLiteral("switch");
    case Role::Procedure:
        return QStringLiteral("procedure");
    case Role::Command:
        return QStringLiteral("command");
    case Role::Status:
        return QStringLiteral("status");
    }
    return {};
}

QString kindWord(Kind kind)
{
    switch (kind) {
    case Kind::Choice:
        return QStringLiteral("choice");
    case Kind::Length:
        return QStringLiteral("length");
    case Kind::Factor:
        return QStringLiteral("factor");
    case Kind::Count:
        return QStringLiteral("count");
    case Kind::Duration:
        return QStringLiteral("duration");
    case Kind::Port:
        return QStringLiteral("port");
    case Kind::Octet:
        return QStringLiteral("octet");
    case Kind::Bits:
        return QStringLiteral("bits");
    case Kind::ErrorCode:
        return QStringLiteral("errorCode");
    case Kind::Trigger:
        return QStringLiteral("trigger");
    case Kind::MacAddress:
        return QStringLiteral("macAddress");
    }
    return {};
}

QString accessWord(Access access)
{
    switch (access) {
    case Access::None:
        return {};
    case Access::Read:
        return QStringLiteral("R");
    case Access::Write:
        return QStringLiteral("W");
    case Access::ReadWrite:
        return QStringLiteral("RW");
    }
    return {};
}

QJsonObject itemJson(const SettingItem& item)
{
    return {{QStringLiteral("key"), QString::fromLatin1(item.key)},
            {QStringLiteral("menu"), numberOrNull(item.menu)},
            {QStringLiteral("name"), QString::fromUtf8(item.name)},
            {QStringLiteral("help"), QString::fromUtf8(item.help)},
            {QStringLiteral("section"), QString::fromLatin1(item.section)},
            {QStringLiteral("role"), roleWord(item.role)},
            {QStringLiteral("kind"), kindWord(item.kind)},
            {QStringLiteral("scope"),
             item.scope == Scope::Bank ? QStringLiteral("bank") : QStringLiteral("common")},
            {QStringLiteral("effect"), item.effect == Effect::AtOnce
                                           ? QStringLiteral("atOnce")
                                           : QStringLiteral("afterCommunicationReset")},
            {QStringLiteral("size"), numberOrNull(item.size)},
            {QStringLiteral("access"), textOrNull(accessWord(item.access))},
            {QStringLiteral("group"), textOrNull(groupKeyOf(item.id))},
            {QStringLiteral("modbus"), numberOrNull(item.modbus ? item.modbus->number : 0)},
            {QStringLiteral("slmp"), numberOrNull(item.slmp ? item.slmp->device : 0)},
            {QStringLiteral("eip"), numberOrNull(item.eip ? item.eip->attribute : 0)},
            {QStringLiteral("unit"), settings::unitText(item)},
            {QStringLiteral("limits"), limitsJson(item)},
            {QStringLiteral("choices"), choicesJson(item)}};
}

QJsonArray catalogJson(const Catalog& catalog)
{
    QJsonArray items;
    for (const SettingItem& item : catalog.items())
        items.append(itemJson(item));
    return items;
}

} // namespace lds::ctl
