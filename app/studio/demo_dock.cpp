#include "demo_dock.h"

#include "scene.h"
#include "theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace lds::app {

using namespace Qt::StringLiterals;
using emulator::FaultDesk;
using emulator::NamedFault;
using emulator::Scene;
using emulator::SensorStation;
using emulator::StationState;
using By = FaultDesk::By;

namespace {

/// What stands behind a row of the workpieces, beside the names of the scene's own.
enum class Held { Moving, Centre, Named };

QString faultName(NamedFault fault)
{
    switch (fault) {
    case NamedFault::NoLight:
        return DemoDock::tr("No light");
    case NamedFault::Saturated:
        return DemoDock::tr("Too much light");
    case NamedFault::AmbientLight:
        return DemoDock::tr("Strong ambient light");
    case NamedFault::OutOfRange:
        return DemoDock::tr("Out of range");
    case NamedFault::LaserCircuitError:
        return DemoDock::tr("Laser circuit error");
    case NamedFault::SystemError:
        return DemoDock::tr("System error");
    case NamedFault::SlowAnswers:
        return DemoDock::tr("Slow to answer");
    case NamedFault::AnswersLost:
        return DemoDock::tr("Answers lost");
    case NamedFault::AnswersCut:
        return DemoDock::tr("Answers cut short");
    case NamedFault::ConnectionDropped:
        return DemoDock::tr("No connection");
    case NamedFault::InMenu:
        return DemoDock::tr("In its menu");
    case NamedFault::Saving:
        return DemoDock::tr("Saving, silent");
    }
    return {};
}

QString faultText(const StationState::Fault& fault)
{
    QString text = faultName(fault.fault);
    if (fault.milliseconds > 0)
        text = DemoDock::tr("%1 (%2 ms)").arg(text).arg(fault.milliseconds);
    return fault.byScene ? DemoDock::tr("%1 · scene").arg(text) : text;
}

QLabel* labelFor(const QString& text, QWidget* buddy, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setBuddy(buddy);
    buddy->setAccessibleName(QString(text).remove(u'&'));
    return label;
}

/// A combo box as narrow as the dock, whatever a scene calls its workpieces.
QComboBox* narrowComboBox(const char* name, QWidget* parent)
{
    auto* box = new QComboBox(parent);
    box->setObjectName(QLatin1StringView(name));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(14);
    return box;
}

} // namespace

DemoDock::DemoDock(emulator::DemoSensor& sensor, QWidget* parent)
    : QDockWidget(tr("Virtual sensor"), parent)
    , m_sensor(sensor)
{
    setObjectName(QStringLiteral("demoDock"));
    setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(12, 4, 12, 12);
    column->setSpacing(6);
    addScenes(*column);
    addWorkpieces(*column);
    addButtons(*column);
    addFaults(*column);
    column->addStretch(1);

    auto* scroll = new QScrollArea(this);
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(content->minimumSizeHint().width() + 12);
    for (qsizetype i = 0; i < m_faults.size(); ++i)
        m_faults.at(i)->setText(faultName(emulator::allFaults().at(i)));
    scroll->setEnabled(false); // until the sensor runs
    setWidget(scroll);
    const auto paintPanel = [content] {
        QPalette own = content->palette();
        own.setColor(QPalette::Window, ui::color(ui::ColorRole::Panel));
        content->setPalette(own);
    };
    content->setAutoFillBackground(true);
    connect(&ui::Theme::instance(), &ui::Theme::changed, content, paintPanel);
    paintPanel();

    const auto enableAndShow = [this, scroll] {
        scroll->setEnabled(true);
        showState(m_sensor.state());
    };
    connect(&sensor, &emulator::DemoSensor::stateChanged, this, enableAndShow);
    connect(&sensor, &emulator::DemoSensor::sceneRefused, this, &DemoDock::showError);
    if (!sensor.state().faults.isEmpty())
        enableAndShow();
}

void DemoDock::addScenes(QVBoxLayout& column)
{
    m_scenes = narrowComboBox("demoScene", this);
    m_scenes->addItem(tr("Moves gently"), QString());
    for (const QString& key : Scene::examples()) {
        const auto scene = Scene::load(key, m_sensor.model());
        m_scenes->addItem(scene ? (*scene)->name() : key, key);
        if (scene)
            m_scenes->setItemData(m_scenes->count() - 1, (*scene)->description(), Qt::ToolTipRole);
    }
    m_open = new QPushButton(tr("&Open a scene file…"), this);
    m_open->setObjectName(QStringLiteral("demoOpenScene"));
    m_error = new QLabel(this);
    m_error->setObjectName(QStringLiteral("demoError"));
    m_error->setProperty("error", true);
    m_error->setWordWrap(true);
    m_error->setTextFormat(Qt::PlainText);
    m_error->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_error->hide();
    column.addWidget(labelFor(tr("S&cene"), m_scenes, this));
    column.addWidget(m_scenes);
    column.addWidget(m_open);
    column.addWidget(m_error);
    connect(m_scenes, &QComboBox::activated, this, [this](int index) {
        m_error->hide();
        m_sensor.loadScene(m_scenes->itemData(index).toString());
    });
    connect(m_open, &QPushButton::clicked, this, &DemoDock::chooseFile);
}

void DemoDock::chooseFile()
{
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Open a scene file"), {}, tr("Scenes (*.json);;All files (*)"));
    if (file.isEmpty())
        return;
    m_error->hide();
    m_sensor.loadScene(file);
}

void DemoDock::addWorkpieces(QVBoxLayout& column)
{
    m_workpieces = narrowComboBox("demoWorkpiece", this);
    column.addWidget(labelFor(tr("&Workpiece"), m_workpieces, this));
    column.addWidget(m_workpieces);
    connect(m_workpieces, &QComboBox::activated, this, &DemoDock::holdChosenWorkpiece);
}

void DemoDock::holdChosenWorkpiece(int index)
{
    const auto held = Held(m_workpieces->itemData(index).toInt());
    m_sensor.post([held, name = m_workpieces->itemText(index)](SensorStation& station) {
        if (held == Held::Moving)
            station.player().letMove();
        else if (held == Held::Centre)
            station.player().holdAt(0);
        else
            station.player().holdStill(name);
    });
}

void DemoDock::addButtons(QVBoxLayout& column)
{
    m_trigger = new QPushButton(this);
    m_trigger->setObjectName(QStringLiteral("demoTrigger"));
    m_trigger->setCheckable(true);
    m_powerCycle = new QPushButton(tr("&Power cycle"), this);
    m_powerCycle->setObjectName(QStringLiteral("demoPowerCycle"));
    m_powerCycle->setToolTip(tr("Off and on again: what was not saved in the sensor is gone."));
    column.addWidget(m_trigger);
    column.addWidget(m_powerCycle);
    connect(m_trigger, &QPushButton::clicked, this, [this](bool on) {
        m_sensor.post([on](SensorStation& station) { station.player().setTrigger(on); });
    });
    connect(m_powerCycle, &QPushButton::clicked, this,
            [this] { m_sensor.post([](SensorStation& station) { station.sensor().powerCycle(); }); });
}

void DemoDock::addFaults(QVBoxLayout& column)
{
    auto* group = new QGroupBox(tr("What goes wrong"), this);
    auto* rows = new QVBoxLayout(group);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    for (const NamedFault fault : emulator::allFaults()) {
        // As wide as it may become, for the width of the dock.
        auto* box = new QCheckBox(
            faultText({fault, false, true, emulator::defaultMilliseconds(fault).value_or(0)}), group);
        box->setObjectName(u"demoFault_"_s + keyOf(fault));
        rows->addWidget(box);
        m_faults += box;
        connect(box, &QCheckBox::clicked, this, [this, fault](bool on) {
            m_sensor.post([fault, on](SensorStation& station) {
                if (on)
                    station.faults().switchOn(fault, By::Person);
                else
                    station.faults().switchOff(fault, By::Person);
            });
        });
    }
    column.addWidget(group);
}

void DemoDock::showState(const StationState& state)
{
    showScene(state);
    showWorkpieces(state);
    for (qsizetype i = 0; i < m_faults.size(); ++i)
        showFault(*m_faults.at(i), state.faults.at(i));
    m_trigger->setChecked(state.triggerByPerson);
    if (state.triggerByPerson)
        m_trigger->setText(tr("&Trigger input: ON"));
    else
        m_trigger->setText(state.triggerByScene ? tr("&Trigger input: ON in the scene")
                                                : tr("&Trigger input: OFF"));
}

void DemoDock::showScene(const StationState& state)
{
    int index = m_scenes->findData(state.scene);
    if (index < 0) { // a file: one row for the latest
        const int own = 1 + int(Scene::examples().size());
        m_scenes->removeItem(own);
        m_scenes->insertItem(own, QFileInfo(state.scene).fileName(), state.scene);
        m_scenes->setItemData(own, state.scene, Qt::ToolTipRole);
        index = own;
    }
    m_scenes->setCurrentIndex(index);
    m_scenes->setToolTip(m_scenes->itemData(index, Qt::ToolTipRole).toString());
}

void DemoDock::showWorkpieces(const StationState& state)
{
    QStringList rows{tr("Moving")};
    if (state.workpieces.isEmpty())
        rows += tr("Held still at the centre");
    rows += state.workpieces;
    QStringList before;
    for (int i = 0; i < m_workpieces->count(); ++i)
        before += m_workpieces->itemText(i);
    if (rows != before) {
        m_workpieces->clear();
        for (qsizetype i = 0; i < rows.size(); ++i) {
            const Held otherwise = state.workpieces.isEmpty() ? Held::Centre : Held::Named;
            m_workpieces->addItem(rows.at(i), int(i == 0 ? Held::Moving : otherwise));
        }
    }
    int index = state.held.isEmpty() ? 0 : 1 + int(state.workpieces.indexOf(state.held));
    if (state.heldAt)
        index = state.workpieces.isEmpty() ? 1 : -1;
    m_workpieces->setCurrentIndex(index);
}

void DemoDock::showFault(QCheckBox& box, const StationState::Fault& fault)
{
    box.setChecked(fault.byPerson);
    // It goes off by itself and cannot be cut short.
    box.setEnabled(fault.fault != NamedFault::Saving || !fault.byPerson);
    const QString text = faultText(fault);
    box.setText(text);
    box.setToolTip(fault.byScene ? tr("The scene has it on at the moment.") : QString());
}

void DemoDock::showError(const QString& reason)
{
    m_error->setText(reason);
    m_error->show();
}

} // namespace lds::app
