#include "sensor_list_model.h"

#include "sentences.h"

#include <QIcon>

namespace lds::ui {

using catalog::ItemId;
using sensor::SensorSession;

namespace {

/// The one word that matters most when not all is well; empty otherwise.
QString troubleWord(const SensorSession& session)
{
    if (session.connection() != sensor::Connection::Ready)
        return connectionWord(session.connection());
    if (session.isSensorNotReady())
        return SensorListModel::tr("in its menu or busy");
    if (session.modelContradicted())
        return SensorListModel::tr("type does not fit");
    if (session.held(ItemId::LaserStop).value_or(0) != 0)
        return SensorListModel::tr("laser stopped");
    const auto& latest = session.latest();
    if (!latest)
        return {};
    if (latest->state & measurement::ErrorBit)
        return SensorListModel::tr("error");
    if (latest->state & measurement::AlarmBit)
        return SensorListModel::tr("alarm");
    if (latest->state & measurement::CautionBit)
        return SensorListModel::tr("caution");
    return {};
}

} // namespace

SensorListModel::State sensorState(const SensorSession& session)
{
    using State = SensorListModel::State;
    switch (session.connection()) {
    case sensor::Connection::Closed:
        return State::Offline;
    case sensor::Connection::Opening:
    case sensor::Connection::Reading:
        return State::Busy;
    case sensor::Connection::Reconnecting:
        return State::Warning;
    case sensor::Connection::Ready:
        break;
    }
    return troubleWord(session).isEmpty() ? State::Good : State::Warning;
}

QString sensorDetail(const SensorSession& session)
{
    const QString type = QString::fromLatin1(session.catalog().model(session.model()).typeName);
    QStringList parts;
    if (session.modelIsStated())
        parts += type;
    else if (!session.heldValues().isEmpty())
        parts += SensorListModel::tr("%1 (assumed)").arg(type);
    const QString trouble = troubleWord(session);
    if (!trouble.isEmpty())
        parts += trouble;
    else if (const auto bank = session.held(ItemId::BankSwitching))
        parts += SensorListModel::tr("bank %1").arg(*bank);
    return parts.join(QStringLiteral(" · "));
}

SensorListModel::SensorListModel(sensor::Workspace& workspace, QObject* parent)
    : QAbstractListModel(parent)
{
    for (SensorSession* session : workspace.sessions())
        add(session);
    connect(&workspace, &sensor::Workspace::added, this, &SensorListModel::add);
    connect(&workspace, &sensor::Workspace::aboutToRemove, this, &SensorListModel::removing);
}

int SensorListModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_sessions.size());
}

QVariant SensorListModel::data(const QModelIndex& index, int role) const
{
    const SensorSession* session = sessionAt(index);
    if (!session)
        return {};
    switch (role) {
    case Qt::DisplayRole:
        return session->name();
    case Qt::ToolTipRole:
        return session->url().toString();
    case Qt::AccessibleTextRole:
        return tr("%1, %2, %3, edits not applied: %4")
            .arg(session->name(), connectionWord(session->connection()), sensorDetail(*session))
            .arg(session->pending().count());
    case StateRole:
        return int(sensorState(*session));
    case DetailRole:
        return sensorDetail(*session);
    case EditsRole:
        return session->pending().count();
    case UrlRole: {
        ports::ConnectionUrl plain = session->url();
        plain.sensor.reset(); // it stands on the line above
        return plain.toString();
    }
    default:
        return {};
    }
}

SensorSession* SensorListModel::sessionAt(const QModelIndex& index) const
{
    return index.isValid() ? m_sessions.value(index.row(), nullptr) : nullptr;
}

QModelIndex SensorListModel::indexOf(const SensorSession* session) const
{
    for (int row = 0; row < int(m_sessions.size()); ++row) {
        if (m_sessions.at(row) == session)
            return index(row);
    }
    return {};
}

void SensorListModel::add(SensorSession* session)
{
    beginInsertRows({}, int(m_sessions.size()), int(m_sessions.size()));
    m_sessions += session;
    endInsertRows();
    const auto tell = [this, session] { changed(session); };
    connect(session, &SensorSession::connectionChanged, this, tell);
    connect(session, &SensorSession::identityChanged, this, tell);
    connect(session, &SensorSession::readinessChanged, this, tell);
    connect(session, &SensorSession::pendingChanged, this, tell);
    connect(session, &SensorSession::heldChanged, this, tell);
    // Measurements come often; only what changes the line is worth repainting it.
    connect(session, &SensorSession::measured, this, [this, session, seen = QString()]() mutable {
        const QString detail = sensorDetail(*session);
        if (std::exchange(seen, detail) != detail)
            changed(session);
    });
}

void SensorListModel::removing(SensorSession* session)
{
    const int row = indexOf(session).row();
    if (row < 0)
        return;
    session->disconnect(this);
    beginRemoveRows({}, row, row);
    m_sessions.removeAt(row);
    endRemoveRows();
}

void SensorListModel::changed(SensorSession* session)
{
    const QModelIndex index = indexOf(session);
    if (index.isValid())
        Q_EMIT dataChanged(index, index);
}

} // namespace lds::ui
