#include "command_desk.h"

#include "command_texts.h"
#include "sentences.h"

#include <QMessageBox>
#include <QPushButton>

namespace lds::ui {

using catalog::ItemId;
using catalog::Value;
using sensor::SensorSession;

CommandDesk::CommandDesk(sensor::Workspace& workspace, QWidget* window)
    : QObject(window)
    , m_window(window)
{
    for (SensorSession* session : workspace.sessions())
        watch(session);
    connect(&workspace, &sensor::Workspace::added, this, &CommandDesk::watch);
}

void CommandDesk::watch(SensorSession* session)
{
    connect(session, &SensorSession::commandFinished, this,
            [this, session](const sensor::CommandReport& report) {
                const auto& item = session->catalog().item(report.item);
                if (report.status == ports::Status::Done)
                    Q_EMIT succeeded(doneText(item, report.value, session->model()));
                else
                    Q_EMIT failed(session, failureSentence(report.failure, &item));
            });
}

void CommandDesk::run(SensorSession* session, ItemId item, Value value)
{
    if (!session)
        return;
    if (const QString why = whyNotNow(*session); !why.isEmpty()) {
        Q_EMIT failed(session, why);
        return;
    }
    if (needsQuestion(item))
        ask(session, item, value);
    else
        runNow(session, item, value);
}

void CommandDesk::ask(SensorSession* session, ItemId item, Value value)
{
    const CommandQuestion question = commandQuestion(item, value, *session);
    auto* box =
        new QMessageBox(QMessageBox::NoIcon, question.title, question.title, QMessageBox::NoButton, m_window);
    box->setObjectName(QStringLiteral("commandQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(question.consequence);
    QPushButton* go = box->addButton(question.action, QMessageBox::AcceptRole);
    go->setObjectName(QStringLiteral("goButton"));
    QPushButton* cancel = box->addButton(QMessageBox::Cancel);
    box->setDefaultButton(cancel);
    box->setEscapeButton(cancel);
    connect(go, &QPushButton::clicked, this, [this, session = QPointer<SensorSession>(session), item, value] {
        if (session)
            runNow(session, item, value);
    });
    box->open();
}

void CommandDesk::runNow(SensorSession* session, ItemId item, Value value)
{
    const auto& description = session->catalog().item(item);
    if (session->run(item, value))
        Q_EMIT started(underWayText(description));
    else
        Q_EMIT failed(session, whyNotNow(*session));
}

} // namespace lds::ui
