#include "session_notices.h"

#include "item_text.h"
#include "sentences.h"

#include <algorithm>

namespace lds::ui {

using catalog::ItemId;
using sensor::Connection;
using sensor::SensorSession;

namespace {

using Kind = Banner::Kind;
const QString connectionSubject = QStringLiteral("connection");
const QString readinessSubject = QStringLiteral("readiness");
const QString laserSubject = QStringLiteral("laser");
const QString modelSubject = QStringLiteral("model");
const QString conflictSubject = QStringLiteral("conflict");
const QString bankSubject = QStringLiteral("bank");
const QString externalSubject = QStringLiteral("external");
const QString failureSubject = QStringLiteral("failure");
const QString informationSubject = QStringLiteral("information");
constexpr int longestList = 3; ///< Names in a sentence before "and n more".

QString typeNames(const SensorSession& session)
{
    QStringList names;
    for (const auto& model : session.catalog().models()) {
        if (session.modelsThatFit() & catalog::maskOf(model.model))
            names += QString::fromLatin1(model.typeName);
    }
    return names.join(QStringLiteral(", "));
}

QString itemNames(const SensorSession& session, const QList<ItemId>& items)
{
    QStringList names;
    for (const ItemId id : items.mid(0, longestList))
        names += itemName(session.catalog().item(id));
    const int more = int(items.size()) - longestList;
    const QString text = names.join(QStringLiteral(", "));
    return more > 0 ? SessionNotices::tr("%1 and %2 more").arg(text).arg(more) : text;
}

} // namespace

bool isLaserStopped(const SensorSession& session)
{
    if (const auto& latest = session.latest())
        return !(latest->state & measurement::LaserBit);
    return session.isReady() && session.held(ItemId::LaserStop).value_or(0) != 0;
}

SessionNotices::SessionNotices(BannerArea& area)
    : QObject(&area)
    , m_area(area)
{}

void SessionNotices::setSession(SensorSession* session)
{
    if (m_session)
        m_session->disconnect(this);
    m_session = session;
    m_area.clear();
    if (!session)
        return;
    connect(session, &SensorSession::connectionChanged, this, &SessionNotices::showConnection);
    connect(session, &SensorSession::connectionChanged, this, &SessionNotices::showReadiness);
    connect(session, &SensorSession::connectionChanged, this, &SessionNotices::showLaser);
    connect(session, &SensorSession::readinessChanged, this, &SessionNotices::showReadiness);
    connect(session, &SensorSession::measured, this, &SessionNotices::showLaser);
    connect(session, &SensorSession::heldChanged, this, &SessionNotices::showLaser);
    connect(session, &SensorSession::heldChanged, this, &SessionNotices::showModel);
    connect(session, &SensorSession::identityChanged, this, &SessionNotices::showModel);
    connect(session, &SensorSession::pendingChanged, this, &SessionNotices::showConflicts);
    connect(session, &SensorSession::externallyChanged, this, &SessionNotices::showExternal);
    showConnection();
    showReadiness();
    showLaser();
    showModel();
    showConflicts();
}

void SessionNotices::showConnection()
{
    if (!m_session)
        return;
    if (m_session->connection() == Connection::Closed) {
        m_area.showMessage(
            connectionSubject,
            {Kind::Information, tr("%1 is not connected.").arg(m_session->name()), tr("Connect"), [this] {
                 if (m_session)
                     m_session->open();
             }});
        return;
    }
    if (m_session->connection() != Connection::Reconnecting) {
        m_area.hideMessage(connectionSubject);
        return;
    }
    const QString why = openFailureSentence(m_session->linkReport(), m_session->url());
    m_area.showMessage(
        connectionSubject,
        {Kind::Error, why.isEmpty() ? connectionWord(m_session->connection()) : why, tr("Try now"), [this] {
             if (m_session)
                 m_session->retryNow();
         }});
}

void SessionNotices::showReadiness()
{
    if (!m_session || !m_session->isSensorNotReady() || m_session->connection() == Connection::Closed ||
        m_session->connection() == Connection::Reconnecting) {
        m_area.hideMessage(readinessSubject);
        return;
    }
    m_area.showMessage(
        readinessSubject,
        {Kind::Warning,
         tr("The sensor is in its menu or busy and takes no requests. Return it to the measurement "
            "display: hold ENTER for 2 seconds. Nothing is lost meanwhile."),
         {},
         {}});
}

void SessionNotices::showLaser()
{
    if (!m_session || !isLaserStopped(*m_session)) {
        m_area.hideMessage(laserSubject);
        return;
    }
    if (m_area.find(laserSubject))
        return; // measurements come often
    m_area.showMessage(laserSubject, {Kind::Warning, tr("The laser is stopped, so nothing is measured."),
                                      m_session->isViewOnly() ? QString() : tr("Switch the laser on"),
                                      [this] { Q_EMIT laserOnRequested(); }});
}

void SessionNotices::showModel()
{
    if (!m_session || m_session->heldValues().isEmpty()) {
        m_area.hideMessage(modelSubject);
        return;
    }
    const QString type = QString::fromLatin1(m_session->catalog().model(m_session->model()).typeName);
    const auto choose = [this] { Q_EMIT typeRequested(); };
    if (m_session->modelContradicted()) {
        const QString fitting = typeNames(*m_session);
        m_area.showMessage(modelSubject,
                           {Kind::Warning,
                            fitting.isEmpty()
                                ? tr("What the sensor holds fits no HL-G2 type. Check that it is one before "
                                     "changing anything.")
                                : tr("What the sensor holds does not fit the chosen type %1. It fits: %2.")
                                      .arg(type, fitting),
                            tr("Choose type…"), choose});
    } else if (!m_session->modelIsStated()) {
        m_area.showMessage(
            modelSubject,
            {Kind::Information,
             tr("Modbus does not tell the type. What the sensor holds fits %1; %2 is assumed, which "
                "sets ranges and decimals. The type is printed on the sensor.")
                 .arg(typeNames(*m_session), type),
             tr("Choose type…"), choose, true});
    } else {
        m_area.hideMessage(modelSubject);
    }
}

void SessionNotices::showConflicts()
{
    QList<ItemId> items;
    if (m_session) {
        const auto& edits = m_session->pending().edits();
        for (auto edit = edits.begin(); edit != edits.end(); ++edit) {
            if (edit->conflict)
                items += edit.key();
        }
    }
    if (items.isEmpty()) {
        m_area.hideMessage(conflictSubject);
        return;
    }
    m_area.showMessage(conflictSubject,
                       {Kind::Warning,
                        tr("The sensor changed under your edits: %1. They are not written until you decide.")
                            .arg(itemNames(*m_session, items)),
                        tr("Decide…"), [this] { Q_EMIT reviewRequested(); }});
}

void SessionNotices::showExternal(const QList<sensor::ExternalChange>& changes)
{
    QList<ItemId> items;
    for (const auto& change : changes) {
        const auto& item = m_session->catalog().item(change.item);
        if (change.item == ItemId::BankSwitching) {
            m_area.showMessage(
                bankSubject,
                {Kind::Information,
                 tr("%1 was switched on by someone else (a PLC or the keys). You see its values now.")
                     .arg(displayValue(item, m_session->model(), change.after)),
                 {},
                 {},
                 true});
        } else if (item.role == catalog::Role::Setting && !m_session->pending().find(change.item)) {
            items += change.item;
        }
    }
    const bool bankChanged =
        std::ranges::any_of(changes, [](const auto& change) { return change.item == ItemId::BankSwitching; });
    if (items.isEmpty() || bankChanged)
        return; // another bank brings other values along; an edit's conflict has a line of its own
    const ItemId first = items.first();
    m_area.showMessage(externalSubject, {Kind::Information,
                                         tr("Changed by someone else: %1.").arg(itemNames(*m_session, items)),
                                         tr("Show"), [this, first] { Q_EMIT itemRequested(first); }, true});
}

void SessionNotices::showFailure(const QString& sentence)
{
    m_area.showMessage(failureSubject, {Kind::Error, sentence, {}, {}, true});
}

void SessionNotices::hideFailure() { m_area.hideMessage(failureSubject); }

void SessionNotices::showInformation(const QString& text)
{
    m_area.showMessage(informationSubject, {Kind::Information, text, {}, {}, true});
}

} // namespace lds::ui
