#include "sensors_panel.h"

#include "action_button.h"
#include "sensor_delegate.h"
#include "sensor_list_model.h"
#include "theme.h"
#include "window_actions.h"

#include <QAction>
#include <QListView>
#include <QMenu>
#include <QShortcut>
#include <QVBoxLayout>

namespace lds::ui {

SensorsPanel::SensorsPanel(sensor::Workspace& workspace, const WindowActions& actions, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_actions(actions)
    , m_model(new SensorListModel(workspace, this))
    , m_list(new QListView(this))
{
    setObjectName(QStringLiteral("sensorsPanel"));
    m_list->setObjectName(QStringLiteral("sensorList"));
    m_list->setAccessibleName(tr("Sensors"));
    m_list->setModel(m_model);
    m_list->setItemDelegate(new SensorDelegate(m_list));
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setMouseTracking(true);
    m_list->setFrameShape(QFrame::NoFrame);
    // Keys that mean something only while the list has the focus.
    const auto onKey = [this](const QKeySequence& keys, QAction* action) {
        auto* shortcut = new QShortcut(keys, m_list, nullptr, nullptr, Qt::WidgetShortcut);
        connect(shortcut, &QShortcut::activated, action, &QAction::trigger);
    };
    onKey(Qt::Key_F2, actions.rename);
    onKey(Qt::Key_Delete, actions.remove);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 0, 12, 12);
    column->setSpacing(8);
    column->addWidget(m_list, 1);
    column->addWidget(new ActionButton(actions.connectSensor, ActionButton::Look::Outline, this));

    // The theme's panel colour behind everything, whichever style draws the dock.
    setAutoFillBackground(true);
    const auto paintPanel = [this] {
        QPalette own = palette();
        own.setColor(QPalette::Window, color(ColorRole::Panel));
        setPalette(own);
    };
    connect(&Theme::instance(), &Theme::changed, this, paintPanel);
    paintPanel();

    const auto select = [this](sensor::SensorSession* session) {
        m_list->setCurrentIndex(m_model->indexOf(session));
    };
    connect(&workspace, &sensor::Workspace::currentChanged, this, select);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& index) {
                if (auto* session = m_model->sessionAt(index))
                    m_workspace.setCurrent(session);
            });
    connect(m_list, &QListView::activated, this, [this] { m_actions.openConnection->trigger(); });
    connect(m_list, &QWidget::customContextMenuRequested, this, &SensorsPanel::showMenu);
    select(workspace.current());
}

void SensorsPanel::showMenu(const QPoint& position)
{
    if (!m_model->sessionAt(m_list->indexAt(position)))
        return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions({m_actions.rename, m_actions.openConnection, m_actions.closeConnection});
    menu->addMenu(m_actions.typeMenu());
    menu->addSeparator();
    menu->addAction(m_actions.remove);
    menu->popup(m_list->viewport()->mapToGlobal(position));
}

} // namespace lds::ui
