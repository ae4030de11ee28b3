#include "bank_buttons.h"

#include "item_text.h"
#include "theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace lds::ui {

using catalog::ItemId;
using sensor::SensorSession;

BankButtons::BankButtons(QWidget* parent)
    : QWidget(parent)
{
    build();
    refresh();
}

void BankButtons::build()
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(Theme::unit);
    auto* label = new QLabel(tr("Bank"), this);
    label->setProperty("muted", true);
    layout->addWidget(label);
    layout->addSpacing(Theme::unit);
    for (const auto& choice : catalog::hlG2(ItemId::BankSwitching).choices) {
        auto* button = new QPushButton(QString::number(choice.code), this);
        button->setCheckable(true);
        button->setProperty("bank", choice.code);
        button->setObjectName(QStringLiteral("bank%1").arg(choice.code));
        button->setFixedWidth(8 * Theme::unit);
        button->setStyleSheet(QStringLiteral("QPushButton { padding: 2px 0; min-height: 16px; }"));
        connect(button, &QPushButton::clicked, this, [this, code = choice.code] {
            const bool isCurrent = m_session && m_session->held(ItemId::BankSwitching) == code;
            refresh(); // the click has pressed the button; the sensor has not switched yet
            if (!isCurrent)
                Q_EMIT requested(code);
        });
        layout->addWidget(button);
        m_buttons.append(button);
    }
}

void BankButtons::setSession(SensorSession* session)
{
    if (m_session)
        disconnect(m_session, nullptr, this, nullptr);
    m_session = session;
    if (session) {
        connect(session, &SensorSession::heldChanged, this, [this](const QList<ItemId>& items) {
            if (items.contains(ItemId::BankSwitching))
                refresh();
        });
        connect(session, &SensorSession::connectionChanged, this, &BankButtons::refresh);
        connect(session, &SensorSession::busyChanged, this, &BankButtons::refresh);
        connect(session, &SensorSession::readinessChanged, this, &BankButtons::refresh);
    }
    refresh();
}

void BankButtons::refresh()
{
    const auto current = m_session ? m_session->held(ItemId::BankSwitching) : std::nullopt;
    const bool usable = m_session && m_session->canWrite() && m_session->reaches(ItemId::BankSwitching) &&
                        !m_session->isRunning() && !m_session->isApplying();
    for (QPushButton* button : m_buttons) {
        const auto code = button->property("bank").toInt();
        const bool isCurrent = current == code;
        QString name = m_session
                           ? displayValue(catalog::hlG2(ItemId::BankSwitching), m_session->model(), code)
                           : button->text();
        if (isCurrent)
            name =
                m_session->isStale() ? tr("%1, in use when last read").arg(name) : tr("%1, in use").arg(name);
        button->setChecked(isCurrent);
        button->setEnabled(usable || isCurrent);
        button->setAccessibleName(name);
        button->setToolTip(isCurrent ? name : tr("Switch to %1 (acts at once)").arg(name));
    }
}

} // namespace lds::ui
