#include "leave_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace lds::ui {

using sensor::SensorSession;

namespace {
struct Words {
    Q_DECLARE_TR_FUNCTIONS(lds::ui::LeaveQuestion)
};
} // namespace

QStringList lossesOf(const QList<SensorSession*>& sessions)
{
    QStringList lines;
    for (const SensorSession* session : sessions) {
        QStringList parts;
        if (session->isApplying())
            parts += Words::tr("changes are being written");
        if (const int edits = session->pending().count())
            parts +=
                edits == 1 ? Words::tr("1 edit not applied") : Words::tr("%1 edits not applied").arg(edits);
        if (session->saved() == sensor::Saved::NotSaved)
            parts += Words::tr("not saved in the sensor: gone when its power goes");
        if (!parts.isEmpty())
            lines += QStringLiteral("%1: %2.").arg(session->name(), parts.join(QStringLiteral("; ")));
    }
    return lines;
}

void askBeforeLeaving(QWidget* window, const QList<SensorSession*>& sessions, const QString& title,
                      const QString& action, std::function<void()> leave)
{
    const QStringList losses = lossesOf(sessions);
    if (losses.isEmpty()) {
        leave();
        return;
    }
    auto* box = new QMessageBox(QMessageBox::NoIcon, title, title, QMessageBox::NoButton, window);
    box->setObjectName(QStringLiteral("leaveQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(losses.join(QStringLiteral("\n")));
    QPushButton* go = box->addButton(action, QMessageBox::DestructiveRole);
    go->setObjectName(QStringLiteral("leaveButton"));
    QPushButton* cancel = box->addButton(QMessageBox::Cancel);
    cancel->setObjectName(QStringLiteral("stayButton"));
    box->setDefaultButton(cancel);
    box->setEscapeButton(cancel);
    QObject::connect(go, &QPushButton::clicked, window, std::move(leave));
    box->open();
}

} // namespace lds::ui
